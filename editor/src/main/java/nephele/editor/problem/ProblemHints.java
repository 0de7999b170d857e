package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.json.WordFormats;
import nephele.engine.level.layout.Leak;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;

/** Hints about an unfinished level, such as a missing start; {@code check} does not report them. */
final class ProblemHints {
    private static final Vec3 BESIDE_START = new Vec3(0, 0, -4);

    private ProblemHints() {}

    /** @param statics {@code null} if they cannot be derived */
    static List<LevelProblem> of(Level level, StaticShapes statics) {
        List<LevelProblem> hints = new ArrayList<>();
        if (level.player() == null) {
            ProblemFix fix = new ProblemFix(ProblemText.ADD_START.words(), now -> withStart(now, statics));
            hints.add(hint("player", ProblemText.NO_START, List.of(), statics == null ? List.of() : List.of(fix)));
        }
        if (level.exits().isEmpty()) {
            ProblemFix fix = new ProblemFix(ProblemText.ADD_EXIT.words(), now -> withExit(now, statics));
            hints.add(hint("exits", ProblemText.NO_EXIT, List.of(), statics == null ? List.of() : List.of(fix)));
        }
        boolean hasOutside =
                level.environment().sky() != null || level.environment().sun() != null;
        List<Vec3> line = hasOutside && statics != null ? Leak.line(level, statics) : List.of();
        if (!line.isEmpty()) {
            hints.add(hint("player.feet", ProblemText.OPEN_TO_OUTSIDE, line, List.of()));
        }
        return hints;
    }

    private static LevelProblem hint(String path, ProblemText text, List<Vec3> line, List<ProblemFix> fixes) {
        return new LevelProblem(
                WordFormats.Choice.word(text) + " " + path,
                ProblemSeverity.HINT,
                path,
                text.words(),
                ProblemMarks.line(line),
                line.isEmpty() ? null : EntityRef.single("player"),
                fixes);
    }

    private static Level withStart(Level now, StaticShapes statics) {
        Vec3 feet = new Floors(now, statics).middle();
        return now.player() != null
                ? now
                : RecordKind.with(now, "player", new PlayerStart(feet == null ? Vec3.ZERO : feet, 0, 0));
    }

    private static Level withExit(Level now, StaticShapes statics) {
        if (!now.exits().isEmpty()) {
            return now;
        }
        Vec3 from = now.player() == null ? Vec3.ZERO : now.player().feet();
        Vec3 far = new Floors(now, statics).farFrom(from);
        return now.withExits(List.of(new Exit("exit", far == null ? from.plus(BESIDE_START) : far, 1, 2)));
    }
}
