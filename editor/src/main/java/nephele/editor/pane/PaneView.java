package nephele.editor.pane;

import nephele.engine.math.Vec3;

/**
 * The view of a pane: an immutable value. It keeps a camera for perspective and one for plans, so that a pane that
 * changes its kind and back shows the same.
 *
 * @param plan of any kind while the pane is a perspective
 */
public record PaneView(PaneKind kind, PerspectiveCamera perspective, PlanCamera plan, ViewMode mode) {
    private static final double FOV_DEGREES = 60;
    private static final double METRES_PER_PIXEL = 0.05;

    public PaneView {
        if (kind != PaneKind.PERSPECTIVE && plan.kind() != kind) {
            plan = new PlanCamera(kind, plan.centre(), plan.metresPerPixel());
        }
    }

    /** Returns a view of the surroundings of the origin. */
    public static PaneView of(PaneKind kind, ViewMode mode) {
        PaneKind plan = kind == PaneKind.PERSPECTIVE ? PaneKind.TOP : kind;
        return new PaneView(
                kind,
                new PerspectiveCamera(new Vec3(6, 5, 10), 30, -20, FOV_DEGREES),
                new PlanCamera(plan, Vec3.ZERO, METRES_PER_PIXEL),
                mode);
    }

    /** Returns the camera of this kind. */
    public PaneCamera camera() {
        return kind == PaneKind.PERSPECTIVE ? perspective : plan;
    }

    /** Returns this view with another camera; the pane's kind becomes that of the camera. */
    public PaneView with(PaneCamera camera) {
        return camera instanceof PlanCamera other
                ? new PaneView(other.kind(), perspective, other, mode)
                : new PaneView(PaneKind.PERSPECTIVE, (PerspectiveCamera) camera, plan, mode);
    }

    /** Returns this view with another mode. */
    public PaneView with(ViewMode other) {
        return new PaneView(kind, perspective, plan, other);
    }

    /** Returns this view with another kind; a plan stays where a plan was. */
    public PaneView with(PaneKind other) {
        return new PaneView(other, perspective, plan, mode);
    }

    /** Returns this view with the next kind. */
    public PaneView cycled() {
        PaneKind[] kinds = PaneKind.values();
        return with(kinds[(kind.ordinal() + 1) % kinds.length]);
    }
}
