// Prints what ExcelJS and SheetJS read of the workbooks named: by program, sheet and cell its formula and its value.
const ExcelJS = require("exceljs");
const SheetJS = require("xlsx");

async function byExcelJS(path) {
  const book = new ExcelJS.Workbook();
  await book.xlsx.readFile(path);
  const sheets = {};
  book.eachSheet(sheet => {
    const cells = (sheets[sheet.name] = {});
    sheet.eachRow(row => row.eachCell(cell => {
      cells[cell.address] = [cell.formula ?? null, (cell.formula ? cell.result : cell.value) ?? null];
    }));
  });
  return sheets;
}

function bySheetJS(path) {
  const sheets = {};
  for (const [name, sheet] of Object.entries(SheetJS.readFile(path).Sheets)) {
    const cells = Object.entries(sheet).filter(([place]) => !place.startsWith("!"));
    sheets[name] = Object.fromEntries(cells.map(([place, cell]) => [place, [cell.f ?? null, cell.v ?? null]]));
  }
  return sheets;
}

(async () => {
  const path = process.argv[2];
  console.log(JSON.stringify({ ExcelJS: await byExcelJS(path), SheetJS: bySheetJS(path) }));
})();
