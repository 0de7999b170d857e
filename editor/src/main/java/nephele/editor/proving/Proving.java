package nephele.editor.proving;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import nephele.editor.pane.Mark;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;

/** The proofs of a session and what the viewport shows of them. Used by the session's thread. */
public final class Proving {
    private final ProblemTour problems;
    private final HeatOverlay heat;
    private final SolutionProof solution;
    private final TracedCorner corner;
    private final TradeReport trade;
    private final TechniqueComparison techniques;
    private final ProvingSubject subject;
    private ProvingThreads threads = ProvingThreads.DIRECT;
    private Vec3 pointed;

    /** Creates the proofs, with nothing shown; they run at once until {@link #runOn}. */
    public Proving(ProvingSubject subject) {
        this.subject = subject;
        problems = new ProblemTour(subject);
        heat = new HeatOverlay(subject, () -> threads);
        solution = new SolutionProof(subject, () -> threads);
        corner = new TracedCorner(subject, () -> threads);
        trade = new TradeReport(subject, () -> threads);
        techniques = new TechniqueComparison(subject, () -> threads);
    }

    /** Sets the threads of all further proofs. */
    public void runOn(ProvingThreads others) {
        threads = others;
    }

    public ProblemTour problems() {
        return problems;
    }

    public HeatOverlay heat() {
        return heat;
    }

    public SolutionProof solution() {
        return solution;
    }

    public TracedCorner corner() {
        return corner;
    }

    public TradeReport trade() {
        return trade;
    }

    public TechniqueComparison techniques() {
        return techniques;
    }

    /** Follows a change of level, selection, panes or files. */
    public void follow() {
        problems.follow();
        solution.follow();
        heat.follow();
        corner.follow();
        techniques.follow();
    }

    /** Takes away the marks of the chosen problem and of the solution. */
    public void dismiss() {
        problems.dismiss();
        solution.dismiss();
    }

    /** Ends everything that runs. */
    public void close() {
        heat.show(false);
        corner.show(false);
        trade.stop();
        techniques.hide();
    }

    /** Returns the marks for all panes. */
    public List<Mark> marks() {
        List<Mark> marks = new ArrayList<>(problems.marks());
        marks.addAll(solution.marks());
        return marks;
    }

    /** Notes the place under the pointer, and tells what the heat map says about it. */
    public void pointed(Optional<Vec3> place) {
        place.ifPresent(at -> {
            pointed = at;
            heat.pointed(at);
        });
    }

    /**
     * Explains the pixel of the perspective pane under the pointer, or else its middle.
     *
     * @param reported receives the explanation on the session's thread
     */
    public void explain(Consumer<PixelExplanation> reported) {
        PaneEye eye = PaneEye.of(subject);
        PaneEye.Pixel pixel = eye.pixel(pointed);
        Level level = subject.level();
        AssetSource assets = subject.assets();
        Language language = subject.language();
        threads.work().execute(() -> {
            PixelExplanation found = PixelExplanation.of(level, assets, language, eye, pixel);
            threads.session().execute(() -> reported.accept(found));
        });
    }
}
