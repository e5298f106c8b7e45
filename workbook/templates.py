"""The register of templates."""

from workbook.machines import composer, cutting
from workbook.template import Template

TEMPLATES = {template.name: template for template in (cutting.TEMPLATE, composer.TEMPLATE)}

__all__ = ["TEMPLATES", "Template"]
