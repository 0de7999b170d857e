package nephele.editor.proving;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.pane.Mark;
import nephele.editor.pane.PaneLayout;
import nephele.editor.pane.PaneView;
import nephele.editor.pane.PerspectiveCamera;
import nephele.editor.pane.PerspectiveNavigation;
import nephele.editor.pane.PlanNavigation;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Points the cameras of all panes at marks; a surface is looked at from its front. */
final class ProblemSight {
    private static final double ASIDE_DEGREES = 25;
    private static final double DOWN_DEGREES = 15;
    private static final double LEAST_METRES = 0.5;

    private ProblemSight() {}

    /** Returns the panes that look at the marks; empty if there are none. */
    static Optional<PaneLayout> of(ProvingSubject subject, List<Mark> marks) {
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
                    PerspectiveNavigation.focus(turned, box, place.size()),
                    PlanNavigation.focus(view.plan(), box, place.size()),
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
