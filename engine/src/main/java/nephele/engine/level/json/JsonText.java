package nephele.engine.level.json;

/** Formats a tree as text: two spaces of indentation and arrays of numbers on one line, or everything on one line. */
final class JsonText {
    private final StringBuilder text = new StringBuilder(1 << 12);
    private final boolean isIndented;

    private JsonText(boolean isIndented) {
        this.isIndented = isIndented;
    }

    /** Returns indented text with a line feed at the end. */
    static String of(JsonValue value) {
        JsonText json = new JsonText(true);
        json.value(value, 0);
        return json.text.append('\n').toString();
    }

    /** Returns one line, without a line feed. */
    static String line(JsonValue value) {
        JsonText json = new JsonText(false);
        json.value(value, 0);
        return json.text.toString();
    }

    private void value(JsonValue value, int indent) {
        if (value instanceof JsonValue.Number number) {
            text.append(NumberText.of(number.value()));
        } else if (value instanceof JsonValue.Text string) {
            quoted(string.value());
        } else if (value instanceof JsonValue.Array array) {
            array(array, indent);
        } else if (value instanceof JsonValue.Members members) {
            object(members, indent);
        } else {
            text.append(value == JsonValue.Literal.TRUE ? "true" : value == JsonValue.Literal.FALSE ? "false" : "null");
        }
    }

    private void array(JsonValue.Array array, int indent) {
        boolean numbers = array.values().stream().allMatch(JsonValue.Number.class::isInstance);
        text.append('[');
        for (int i = 0; i < array.values().size(); i++) {
            text.append(i == 0 ? "" : numbers ? ", " : between());
            if (!numbers) {
                newLine(indent + 1);
            }
            value(array.values().get(i), indent + 1);
        }
        if (!numbers) {
            newLine(indent);
        }
        text.append(']');
    }

    private void object(JsonValue.Members members, int indent) {
        text.append('{');
        for (int i = 0; i < members.size(); i++) {
            text.append(i == 0 ? "" : between());
            newLine(indent + 1);
            quoted(members.name(i));
            text.append(": ");
            value(members.value(i), indent + 1);
        }
        if (members.size() > 0) {
            newLine(indent);
        }
        text.append('}');
    }

    private String between() {
        return isIndented ? "," : ", ";
    }

    private void newLine(int indent) {
        if (!isIndented) {
            return;
        }
        text.append('\n');
        for (int i = 0; i < indent; i++) {
            text.append("  ");
        }
    }

    private void quoted(String string) {
        text.append('"');
        for (int i = 0; i < string.length(); i++) {
            char c = string.charAt(i);
            switch (c) {
                case '"' -> text.append("\\\"");
                case '\\' -> text.append("\\\\");
                case '\n' -> text.append("\\n");
                case '\t' -> text.append("\\t");
                default -> text.append(c < ' ' ? String.format(java.util.Locale.ROOT, "\\u%04x", (int) c) : c);
            }
        }
        text.append('"');
    }
}
