package nephele.engine.level;

import java.util.Map;

/**
 * Help for a player who is stuck, given on request.
 *
 * @param text in each language; English stands for those that it lacks
 * @param afterSeconds of play after which it is offered, or of play near the place
 * @param near where the time counts and the hint is offered; {@code null} for the whole level
 */
public record Hint(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, text = TextKind.NAME, prototype = "{\"en\": \"Look around.\"}")
                Map<Language, String> text,
        @Written(absent = "60") @Range(min = 0, max = 3600) double afterSeconds,
        @Written Place near) {
    /** Returns the text in a language, or in English. */
    public String text(Language language) {
        return text.getOrDefault(language, text.getOrDefault(Language.EN, ""));
    }
}
