package nephele.editor.proving;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.document.Selection;
import nephele.editor.pane.Mark;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PlanCamera;
import nephele.editor.problem.LevelProblem;
import nephele.editor.problem.ProblemSearch;
import nephele.engine.level.Level;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The problems of the level, one of which can be chosen: its place is looked at and marked. */
public final class ProblemTour {
    private static final double ASIDE_DEGREES = 25;
    private static final double DOWN_DEGREES = 15;
    private static final double LEAST_METRES = 0.5;

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
            chosen = listed().stream()
                    .filter(problem -> problem.key().equals(key))
                    .findFirst()
                    .orElse(null);
            subject.redraw();
        }
    }

    /** Returns the problems that are not hidden; of a level whose search has no result yet, after one. */
    public List<LevelProblem> listed() {
        if (foundOf != subject.level()) {
            Level searched = subject.level();
            found = subject.background().get(() -> ProblemSearch.of(searched, subject.assets()));
            foundOf = searched;
        }
        List<LevelProblem> listed = new ArrayList<>(found);
        listed.removeIf(problem -> LevelProblem.isHidden(subject.level(), problem));
        return listed;
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
        lookingAt(subject, problem.marks()).ifPresent(subject::panes);
        subject.status(problem.message());
        subject.redraw();
    }

    /**
     * Returns the problem some steps after the chosen one, or before it; after the last comes the first.
     *
     * @return empty if there are no problems
     */
    public Optional<LevelProblem> step(int steps) {
        List<LevelProblem> listed = listed();
        if (listed.isEmpty()) {
            return Optional.empty();
        }
        int at = chosen == null ? (steps > 0 ? -1 : 0) : indexOf(listed, chosen.key());
        return Optional.of(listed.get(Math.floorMod(at + steps, listed.size())));
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

    /** Returns the panes that look at the marks; empty if there are none. */
    static Optional<PaneLayout> lookingAt(ProvingSubject subject, List<Mark> marks) {
        List<Vec3> points = points(marks);
        Aabb box = Aabb.of(points).grown(points.isEmpty() ? 0 : LEAST_METRES);
        if (points.isEmpty()) {
            return Optional.empty();
        }
        PaneLayout result = subject.panes();
        for (PaneLayout.PaneRectangle place : result.rectangles(subject.viewport(), PaneLayout.GAP_PIXELS)) {
            PaneView view = result.views().get(place.index());
            PerspectiveCamera turned = turned(view.perspective(), marks);
            PaneView looking = new PaneView(
                    view.kind(),
                    PerspectiveCamera.focus(turned, box, place.size()),
                    PlanCamera.focus(view.plan(), box, place.size()),
                    view.mode());
            result = result.with(place.index(), looking);
        }
        return Optional.of(result);
    }

    private static List<Vec3> points(List<Mark> marks) {
        List<Vec3> points = new ArrayList<>();
        for (Mark mark : marks) {
            if (mark instanceof Mark.Line line) {
                points.add(line.from());
                points.add(line.to());
            } else if (mark instanceof Mark.Polygon area) {
                points.addAll(area.corners());
            } else if (mark instanceof Mark.Handle handle) {
                points.add(handle.at());
            }
        }
        return points;
    }

    /** Returns the camera turned to the front of the first surface, a little from the side and from above. */
    private static PerspectiveCamera turned(PerspectiveCamera camera, List<Mark> marks) {
        Optional<Vec3> normal = marks.stream()
                .filter(Mark.Polygon.class::isInstance)
                .map(mark -> normal(((Mark.Polygon) mark).corners()))
                .filter(each -> each.length() > 0.5)
                .findFirst();
        if (normal.isEmpty() || normal.get().dot(camera.forward()) < -0.3) {
            return camera;
        }
        Vec3 sight = normal.get().negated();
        boolean isLevel = Math.abs(sight.y()) > 0.99;
        double yaw = isLevel ? camera.yawDegrees() : Math.toDegrees(Math.atan2(-sight.x(), -sight.z())) + ASIDE_DEGREES;
        double pitch = Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, sight.y()))));
        double tilted = isLevel ? pitch * (90 - 2 * ASIDE_DEGREES) / 90 : pitch - DOWN_DEGREES;
        return new PerspectiveCamera(camera.eye(), yaw, tilted, camera.verticalFovDegrees());
    }

    private static Vec3 normal(List<Vec3> corners) {
        Vec3 sum = Vec3.ZERO;
        for (int i = 2; i < corners.size(); i++) {
            sum = sum.plus(corners.get(i - 1)
                    .minus(corners.get(0))
                    .cross(corners.get(i).minus(corners.get(0))));
        }
        return sum.length() > 0 ? sum.scaled(1 / sum.length()) : sum;
    }
}
