"""The register of templates."""

from workbook.machines import cutting
from workbook.template import Template

TEMPLATES = {template.name: template for template in (cutting.TEMPLATE,)}

__all__ = ["TEMPLATES", "Template"]
