package nephele.workshop.prove.editor;

import java.awt.Point;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Supplier;
import nephele.editor.action.ProvingActions;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemSearch;
import nephele.editor.proving.TracedCorner;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.editor.window.file.FileDrops;

/** Random input that has no place on the picture of the editor: problems of an earlier level, dropped files. */
final class RandomSessionInput {
    private static final int SAMPLES = 1;

    private final EditorUnderEvents editor;
    private final SplittableRandom random;
    private final Supplier<Path> dropped;
    private final FileDrops drops;
    private List<LevelProblem> problems = List.of();

    /** @param dropped chooses the next file to drop */
    RandomSessionInput(EditorUnderEvents editor, SplittableRandom random, Supplier<Path> dropped) {
        this.editor = editor;
        this.random = random;
        this.dropped = dropped;
        EditorSession session = editor.session();
        drops = new FileDrops(session, editor.panel().viewport(), random::nextBoolean, session::status);
    }

    /** Drops a file; returns the event in words. */
    String drop() {
        Path file = dropped.get();
        int width = Math.max(1, editor.panel().viewport().getWidth());
        int height = Math.max(1, editor.panel().viewport().getHeight());
        drops.drop(List.of(file), new Point(random.nextInt(width + 20), random.nextInt(height + 20)));
        return "drop " + file.getFileName();
    }

    /** Chooses, fixes or hides a problem, which may be one of a level before the last edits; returns it in words. */
    String problem() {
        EditorSession session = editor.session();
        if (problems.isEmpty() || random.nextInt(3) == 0) {
            problems = session.background()
                    .get(() -> ProblemSearch.of(session.document().level(), session.assets()));
            session.proving().problems().found(problems);
        }
        if (problems.isEmpty()) {
            return "no problem";
        }
        LevelProblem problem = problems.get(random.nextInt(problems.size()));
        int what = random.nextInt(4);
        if (what == 0) {
            ProvingActions.choose(session, problem);
        } else if (what == 1) {
            session.document().edit(Words.same("hide"), level -> LevelProblem.hide(level, problem));
        } else if (!problem.fixes().isEmpty()) {
            LevelProblem.Fix fix =
                    problem.fixes().get(random.nextInt(problem.fixes().size()));
            session.document().edit(fix.label(), fix.change());
        }
        return "problem " + what + ": " + problem.path() + " " + problem.message();
    }

    /** Shows the path-traced corner, which is slow, or takes it away. */
    String trace() {
        TracedCorner corner = editor.session().proving().corner();
        corner.show(!corner.isVisible(), SAMPLES);
        return "traced corner " + corner.isVisible();
    }
}
