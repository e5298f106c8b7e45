"""As much of JSON Schema as our schemas use: what is wrong with a description, by the places where it is."""

KINDS = {"object": dict, "array": list, "string": str, "null": type(None), "boolean": bool}


def wrong(schema, root, data, at=""):
    """The places that do not keep to a schema."""
    if "$ref" in schema:
        schema = root["$defs"][schema["$ref"].rpartition("/")[2]]
    if "anyOf" in schema and not any(wrong(one, root, data, at) == [] for one in schema["anyOf"]):
        return [at]
    found = [at] * (not of_kind(schema, data) or not within(schema, data))
    for one in (*schema.get("allOf", ()), *([schema] if "if" in schema else [])):
        way = "then" if wrong(one["if"], root, data, at) == [] else "else"
        found += wrong(one.get(way, {}), root, data, at)
    return found + (below(schema, root, data, at) if isinstance(data, dict | list) else [])


def below(schema, root, data, at):
    if isinstance(data, list):
        item = schema.get("items", {})
        return [place for i, one in enumerate(data) for place in wrong(item, root, one, f"{at}.{i}")]
    found = [f"{at}.{name}" for name in schema.get("required", ()) if name not in data]
    known, others = schema.get("properties", {}), schema.get("additionalProperties", True)
    for name, one in data.items():
        inner = known.get(name, others)
        found += [f"{at}.{name}"] * (inner is False)
        found += wrong(inner, root, one, f"{at}.{name}") if isinstance(inner, dict) else []
    return found


def of_kind(schema, data):
    kind = schema.get("type")
    if kind in ("number", "integer"):
        return isinstance(data, (int, float) if kind == "number" else int) and not isinstance(data, bool)
    return kind is None or isinstance(data, KINDS[kind])


def within(schema, data):
    if ("const" in schema and data != schema["const"]) or ("enum" in schema and data not in schema["enum"]):
        return False
    if isinstance(data, str | list):
        least, most = ("minLength", "maxLength") if isinstance(data, str) else ("minItems", "maxItems")
        return schema.get(least, 0) <= len(data) <= schema.get(most, 1e9)
    if isinstance(data, bool) or not isinstance(data, int | float):
        return True
    above = data > schema.get("exclusiveMinimum", -1e99) and data >= schema.get("minimum", -1e99)
    return above and data < schema.get("exclusiveMaximum", 1e99) and data <= schema.get("maximum", 1e99)
