"""The register of templates."""

from workbook.machines import composer, cutting, flying, overlap
from workbook.template import Template

TEMPLATES = {
    template.name: template for template in (cutting.TEMPLATE, composer.TEMPLATE, overlap.TEMPLATE, flying.TEMPLATE)
}

__all__ = ["TEMPLATES", "Template"]
