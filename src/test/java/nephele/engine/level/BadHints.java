package nephele.engine.level;

import static nephele.engine.level.BadLevel.level;

import java.util.List;

/** Hints that nobody can read or tell apart, and a landmark without an extent. */
final class BadHints {
    private static final String PLAYER = "\"player\": {\"feet\": [0, 0, 5]}, ";

    static final List<BadLevel> ALL = List.of(
            level("hints[1].id", "already the id", PLAYER + hints("a", "{\"en\": \"x\"}", "a", "{\"en\": \"y\"}")),
            level("hints[1].text", "no English", PLAYER + hints("a", "{\"en\": \"x\"}", "b", "{\"pt-BR\": \"y\"}")),
            level("hints[0].text.PT-BR", "given twice", hints("a", "{\"pt-br\": \"x\", \"PT-BR\": \"y\"}")),
            level("hints[0].text.fr", "known here: [en, pt-br, pt-pt]", hints("a", "{\"fr\": \"x\"}")),
            level("hints[0].afterSeconds", "must be from 0", hints("a", "{\"en\": \"x\"}, \"afterSeconds\": -1")),
            level("hints[0].near", "", hints("a", "{\"en\": \"x\"}, \"near\": {}")),
            level(
                    "landmark.radiusMetres",
                    "must be from",
                    "\"landmark\": {\"position\": [0, 1, 0], \"radiusMetres\": 0}"));

    private BadHints() {}

    private static String hints(String... idsAndTexts) {
        StringBuilder all = new StringBuilder("\"hints\": [");
        for (int i = 0; i < idsAndTexts.length; i += 2) {
            all.append(i == 0 ? "" : ", ")
                    .append("{\"id\": \"" + idsAndTexts[i] + "\", \"text\": " + idsAndTexts[i + 1] + "}");
        }
        return all + "]";
    }
}
