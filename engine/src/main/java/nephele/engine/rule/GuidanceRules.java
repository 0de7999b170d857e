package nephele.engine.rule;

import java.util.Map;
import java.util.function.Consumer;
import nephele.engine.level.Hint;
import nephele.engine.level.Language;
import nephele.engine.level.Problem;
import nephele.engine.level.json.WordFormats;
import nephele.engine.level.placed.LevelRule;

/** Rules for what the game tells a player: hints that can be read and are given, a par that can be reached. */
final class GuidanceRules {
    /** The longest text that the smallest window shows whole. */
    private static final int MOST_LETTERS = 140;

    static final LevelRule HINTS = LevelRule.ofRecords((level, report) -> {
        LevelRule.each("hints", level.hints(), (path, hint) -> text(path + ".text", hint, report));
        if (!level.hints().isEmpty() && level.player() == null) {
            report.accept(Problem.warning("hints", "nobody plays the level: add a player, or delete the hints"));
        }
    });

    static final LevelRule PAR = LevelRule.ofRecords((level, report) -> {
        if (level.par() != null && level.exits().isEmpty()) {
            report.accept(Problem.warning("par", "nothing ends the level: add an exit, or leave the par out"));
        } else if (level.par() != null && level.par().portals() > 0 && level.portalGun() == null) {
            report.accept(Problem.warning("par.portals", "nobody can shoot portals here: add a portalGun, or write 0"));
        }
    });

    private GuidanceRules() {}

    private static void text(String path, Hint hint, Consumer<Problem> report) {
        String english = hint.text().get(Language.EN);
        if (english == null || english.isBlank()) {
            report.accept(Problem.error(
                    path, "has no English text, which stands for every language that is missing: add en"));
        }
        for (Map.Entry<Language, String> authored : hint.text().entrySet()) {
            int letters =
                    authored.getValue().codePointCount(0, authored.getValue().length());
            if (letters > MOST_LETTERS) {
                report.accept(Problem.warning(
                        path + "." + WordFormats.Choice.word(authored.getKey()),
                        letters + " letters are too long for a small window: use at most " + MOST_LETTERS));
            }
        }
    }
}
