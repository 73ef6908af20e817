"""Parser for untrusted XML."""

import re
from xml.etree.ElementTree import Element, ParseError, TreeBuilder

from defusedxml import DefusedXmlException, EntitiesForbidden
from defusedxml.ElementTree import DefusedXMLParser

from exactsweep.formats.error import FormatError
from exactsweep.formats.size import ELEMENT, require_count, require_size

MAX_DEPTH = 100  # of nested elements
# References to entities, outside comments, CDATA and processing instructions.
_REFERENCE = re.compile(
    r"<!--.*?(?:-->|\Z)|<!\[CDATA\[.*?(?:]]>|\Z)|<\?.*?(?:\?>|\Z)"
    r"|&(?!(?:lt|gt|amp|quot|apos);|#)(?P<entity>[^\s;&<]++);",
    re.DOTALL,
)
_LINE = "#line"  # not a valid XML name, so it cannot collide with an attribute
_MAX_ENTITY = 200  # entities, and characters in each


def parse_xml(text: str) -> Element:
    """Parse an XML document; never fetch its document type, and reject harmful entities."""
    require_size(len(text))

    class Builder(TreeBuilder):
        depth = count = 0

        def start(self, tag: str, attributes: dict[str, str]) -> Element:
            self.depth += 1
            self.count += 1
            number = parser.parser.CurrentLineNumber
            if self.depth > MAX_DEPTH:
                raise FormatError(f"line {number}: nested deeper than {MAX_DEPTH} elements")
            require_count(self.count, ELEMENT, "elements")
            return super().start(tag, {**attributes, _LINE: str(number)})

        def end(self, tag: str) -> Element:
            self.depth -= 1
            return super().end(tag)

    declared: dict[str, int] = {}

    def declare(name: str, is_parameter: bool, value: str | None, *outside: object) -> None:
        declared[name] = size = len(value or "")
        # Illustrator declares namespaces as entities.
        if is_parameter or value is None or "&" in value or max(size, len(declared)) > _MAX_ENTITY:
            raise EntitiesForbidden(name, value, *outside)
        require_size(text.count(f"&{name};") * size, f"the entity {name!a} expands to ")

    parser = DefusedXMLParser(
        target=Builder(), forbid_dtd=False, forbid_entities=False, forbid_external=True
    )
    parser.parser.EntityDeclHandler = declare
    try:
        parser.feed(text)
        root: Element = parser.close()
    except UnicodeEncodeError:
        raise FormatError("not XML: lone surrogate") from None
    except ParseError as error:
        number, column = error.position
        reason = str(error).partition(":")[0]
        raise FormatError(f"line {number}, column {column + 1}: not XML: {reason}") from None
    except EntitiesForbidden as error:
        raise FormatError(f"declares the entity {error.name!a}, which is not allowed") from None
    except DefusedXmlException as error:
        raise FormatError(f"refers to an external resource: {error}") from None
    # The parser skips references that an external document type might declare.
    for match in _REFERENCE.finditer(text):
        if match["entity"] not in {None, *declared}:
            number = text.count("\n", 0, match.start()) + 1
            raise FormatError(f"line {number}: the entity {match['entity']!a} is not declared here")
    return root


def line(element: Element) -> str:
    return element.attrib[_LINE]
