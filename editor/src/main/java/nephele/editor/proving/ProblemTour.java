package nephele.editor.proving;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.document.Selection;
import nephele.editor.pane.Mark;
import nephele.editor.problem.HiddenProblems;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemSearch;
import nephele.engine.level.Level;

/** The problems of the level, one of which can be chosen: its place is looked at and marked. */
public final class ProblemTour {
    private final ProvingSubject subject;
    private List<LevelProblem> found = List.of();
    private Level foundOf;
    private LevelProblem chosen;
    private Selection chosenWith = Selection.NONE;

    ProblemTour(ProvingSubject subject) {
        this.subject = subject;
    }

    /** Takes the result of a search of the present level, as a panel makes it after each edit. */
    public void found(List<LevelProblem> problems) {
        foundOf = subject.level();
        found = List.copyOf(problems);
        if (chosen != null) {
            String key = chosen.key();
            chosen = shown().stream()
                    .filter(problem -> problem.key().equals(key))
                    .findFirst()
                    .orElse(null);
            subject.redraw();
        }
    }

    /** Returns the problems that are not hidden; of a level whose search has no result yet, after one. */
    public List<LevelProblem> shown() {
        if (foundOf != subject.level()) {
            Level searched = subject.level();
            found = subject.background().get(() -> ProblemSearch.of(searched, subject.assets()));
            foundOf = searched;
        }
        List<LevelProblem> shown = new ArrayList<>(found);
        shown.removeIf(problem -> HiddenProblems.isHidden(subject.level(), problem));
        return shown;
    }

    /** Returns the problem whose place is marked. */
    public Optional<LevelProblem> chosen() {
        return Optional.ofNullable(chosen);
    }

    /**
     * Marks the place of a problem and looks at it. Call it after selecting the problem's entity: another selection takes
     * the marks away.
     */
    public void choose(LevelProblem problem) {
        chosen = problem;
        chosenWith = subject.selection();
        ProblemSight.of(subject, problem.marks()).ifPresent(subject::panes);
        subject.status(problem.message());
        subject.redraw();
    }

    /**
     * Returns the problem some steps after the chosen one, or before it; after the last comes the first.
     *
     * @return empty if there are no problems
     */
    public Optional<LevelProblem> step(int steps) {
        List<LevelProblem> shown = shown();
        if (shown.isEmpty()) {
            return Optional.empty();
        }
        int at = chosen == null ? (steps > 0 ? -1 : 0) : indexOf(shown, chosen.key());
        return Optional.of(shown.get(Math.floorMod(at + steps, shown.size())));
    }

    private static int indexOf(List<LevelProblem> problems, String key) {
        for (int i = 0; i < problems.size(); i++) {
            if (problems.get(i).key().equals(key)) {
                return i;
            }
        }
        return -1;
    }

    /** Takes the marks away after another selection. */
    void follow() {
        if (chosen != null && !subject.selection().equals(chosenWith)) {
            dismiss();
        }
    }

    /** Takes the marks away. */
    public void dismiss() {
        if (chosen != null) {
            chosen = null;
            subject.redraw();
        }
    }

    List<Mark> marks() {
        return chosen == null ? List.of() : chosen.marks();
    }
}
