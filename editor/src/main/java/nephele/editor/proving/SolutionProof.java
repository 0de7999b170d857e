package nephele.editor.proving;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.play.PlayText;
import nephele.editor.play.SolutionCheck;
import nephele.editor.play.SolutionVerdict;
import nephele.editor.play.SolutionVerdict.Deviation;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.sim.state.SimLevel;

/** The check of the level's recorded solution, and the mark where it first goes astray. */
public final class SolutionProof {
    private static final Vec3 BODY = new Vec3(0.6, 1.8, 0.6);

    private final ProvingSubject subject;
    private final Supplier<ProvingThreads> threads;
    /** Ends the check in progress; {@code null} before the first. */
    private Runnable cancel;

    private SolutionVerdict verdict;
    private String failure;
    private Level checked;
    private List<Mark> marks = List.of();

    SolutionProof(ProvingSubject subject, Supplier<ProvingThreads> threads) {
        this.subject = subject;
        this.threads = threads;
    }

    /** Replays the solution beside a level's file in the level as it is now; a check in progress ends. */
    public void check(Path file) {
        if (cancel != null) {
            cancel.run();
        }
        verdict = null;
        failure = null;
        marks = List.of();
        checked = subject.level();
        AssetSource assets = subject.assets();
        Level level = checked;
        Supplier<SimLevel> present = () -> SimLevel.of(PlacedLevel.of(level, assets));
        cancel = SolutionCheck.start(
                file,
                threads.get().work(),
                () -> usable(present),
                fraction -> onSession(level, () -> subject.status(PlayText.CHECKING.with(Math.round(100 * fraction)))),
                result -> onSession(level, () -> checked(result)),
                message -> onSession(level, () -> failed(message)));
    }

    private static SimLevel usable(Supplier<SimLevel> present) {
        try {
            return present.get();
        } catch (AssetException | IllegalArgumentException unusable) {
            throw nephele.host.terminal.CommandFailure.input(unusable.getMessage());
        }
    }

    private void onSession(Level level, Runnable reported) {
        threads.get().session().execute(() -> {
            if (checked == level) {
                reported.run();
            }
        });
    }

    private void checked(SolutionVerdict result) {
        verdict = result;
        marks = result.deviation().map(SolutionProof::marks).orElse(List.of());
        subject.status(PlayText.of(result));
        ProblemTour.lookingAt(subject, marks).ifPresent(subject::panes);
        subject.redraw();
    }

    private void failed(String message) {
        failure = message;
        subject.status(Words.same(message));
    }

    private static List<Mark> marks(Deviation first) {
        List<Mark> marks = new ArrayList<>(body(first.place(), MarkColour.PROBLEM));
        if (!first.expected().equals(first.place())) {
            marks.addAll(body(first.expected(), MarkColour.ALLOWED));
            marks.add(new Mark.Line(first.expected(), first.place(), MarkColour.PROBLEM, Mark.Visibility.ALWAYS));
        }
        return List.copyOf(marks);
    }

    private static List<Mark> body(Vec3 feet, MarkColour colour) {
        return Mark.box(
                Aabb.around(feet.addScaled(BODY.y() / 2, new Vec3(0, 1, 0)), BODY), colour, Mark.Visibility.ALWAYS);
    }

    /** Returns the result of the last check; empty before its end. */
    public Optional<SolutionVerdict> verdict() {
        return Optional.ofNullable(verdict);
    }

    /** Returns why the last check was not possible; empty if it was. */
    public Optional<String> failure() {
        return Optional.ofNullable(failure);
    }

    /** A verdict is about the level that was checked: an edit takes its marks away and ends a check in progress. */
    void follow() {
        if (checked != null && subject.level() != checked) {
            if (cancel != null) {
                cancel.run();
            }
            checked = null;
            dismiss();
        }
    }

    void dismiss() {
        if (!marks.isEmpty()) {
            marks = List.of();
            subject.redraw();
        }
    }

    List<Mark> marks() {
        return marks;
    }
}
