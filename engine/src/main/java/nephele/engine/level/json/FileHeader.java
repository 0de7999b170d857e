package nephele.engine.level.json;

/**
 * The first two keys of every file of this project.
 *
 * @param noun the kind of file in messages: "level"
 */
record FileHeader(String noun, String format, int version) {
    JsonValue.Members written() {
        return new JsonValue.Members()
                .with("format", new JsonValue.Text(format))
                .with("version", new JsonValue.Number(version));
    }

    /** Returns false after it has reported why the rest cannot be read. */
    boolean isThat(JsonValue.Members members, Problems problems) {
        int before = problems.count();
        if (!(members.ask("format") instanceof JsonValue.Text text)
                || !text.value().equals(format)) {
            report("format", "a " + noun + " file says \"format\": \"" + format + "\"", problems);
        }
        JsonValue stated = members.ask("version");
        if (!(stated instanceof JsonValue.Number number) || number.value() != Math.rint(number.value())) {
            report("version", "a " + noun + " file says \"version\": " + version, problems);
        } else if (number.value() != version) {
            String which = number.value() > version ? "newer than this program reads" : "not one that ever existed";
            report("version", "version " + number.text() + " is " + which + " (" + version + ")", problems);
        }
        return problems.count() == before;
    }

    private static void report(String key, String message, Problems problems) {
        int mark = problems.enter(key);
        problems.error(message);
        problems.leave(mark);
    }
}
