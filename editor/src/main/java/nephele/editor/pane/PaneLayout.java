package nephele.editor.pane;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.engine.level.Camera;
import nephele.engine.level.Level;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;

/**
 * The arrangement of the panes in the viewport: an immutable value. There are always four views, of which the
 * arrangement shows the first ones, or only the active one if it is maximised.
 *
 * @param active index of the pane that receives keys
 * @param columnFraction fraction of the width that the left column has
 * @param rowFraction fraction of the height that the upper row has
 */
public record PaneLayout(
        Arrangement arrangement,
        int active,
        boolean isMaximised,
        double columnFraction,
        double rowFraction,
        List<PaneView> views) {
    /** Pixels between two panes at scale 1. */
    public static final int GAP_PIXELS = 4;

    private static final int PANES = 4;
    private static final double OPENING_EYE_METRES = 1.65;
    private static final double LEAST_FRACTION = 0.1;

    /** The number and order of panes. */
    public enum Arrangement {
        ONE(1),
        /** Side by side. */
        TWO(2),
        /** A grid of two columns and two rows. */
        FOUR(4);

        private final int panes;

        Arrangement(int panes) {
            this.panes = panes;
        }
    }

    /** A divider between panes, which the pointer can drag. */
    public enum Splitter {
        COLUMNS,
        ROWS,
        BOTH
    }

    /**
     * The place of a pane, in pixels from the upper left corner of the viewport.
     *
     * @param index of its view
     */
    public record PaneRectangle(int index, int x, int y, int width, int height) {
        /** Returns the size of the pane. */
        public PaneSize size() {
            return new PaneSize(width, height);
        }

        boolean contains(double pixelX, double pixelY) {
            return pixelX >= x && pixelX < x + width && pixelY >= y && pixelY < y + height;
        }
    }

    public PaneLayout {
        views = List.copyOf(views);
        if (views.size() != PANES) {
            throw new IllegalArgumentException("a layout has four views");
        }
        active = Math.max(0, Math.min(arrangement.panes - 1, active));
        columnFraction = limited(columnFraction);
        rowFraction = limited(rowFraction);
    }

    private static double limited(double fraction) {
        return Double.isNaN(fraction) ? 0.5 : Math.max(LEAST_FRACTION, Math.min(1 - LEAST_FRACTION, fraction));
    }

    /** Returns the layout of a first start: a perspective beside the plans. */
    public static PaneLayout initial() {
        List<PaneView> views = List.of(
                PaneView.of(PaneKind.PERSPECTIVE, ViewMode.LIT),
                PaneView.of(PaneKind.TOP, ViewMode.WIREFRAME),
                PaneView.of(PaneKind.FRONT, ViewMode.WIREFRAME),
                PaneView.of(PaneKind.SIDE, ViewMode.WIREFRAME));
        return new PaneLayout(Arrangement.FOUR, 0, false, 0.5, 0.5, views);
    }

    /** Returns the panes of a level that has just been opened, seen from its first camera, else from where its player starts. */
    public PaneLayout opened(Level level) {
        if (!level.cameras().isEmpty()) {
            Camera camera = level.cameras().get(0);
            Vec3 along = camera.target().minus(camera.position());
            double yaw = Math.toDegrees(Math.atan2(-along.x(), -along.z()));
            double pitch = Math.toDegrees(Math.atan2(along.y(), Math.hypot(along.x(), along.z())));
            return from(camera.position(), yaw, pitch, camera.target());
        } else if (level.player() != null) {
            PlayerStart start = level.player();
            Vec3 eye = start.feet().plus(new Vec3(0, OPENING_EYE_METRES, 0));
            return from(eye, start.yawDegrees(), start.pitchDegrees(), start.feet());
        }
        return this;
    }

    /** @param middle the centre of plans */
    private PaneLayout from(Vec3 eye, double yawDegrees, double pitchDegrees, Vec3 middle) {
        return each(view -> new PaneView(
                view.kind(),
                new PerspectiveCamera(
                        eye, yawDegrees, pitchDegrees, view.perspective().verticalFovDegrees()),
                PlanCamera.at(view.plan(), middle),
                view.mode()));
    }

    /** Returns panes with each view changed, drawn or not. */
    public PaneLayout each(UnaryOperator<PaneView> change) {
        PaneLayout result = this;
        for (int i = 0; i < views.size(); i++) {
            result = result.with(i, change.apply(views.get(i)));
        }
        return result;
    }

    /** Returns the active pane's view. */
    public PaneView activeView() {
        return views.get(active);
    }

    /**
     * Returns the camera of the perspective pane: the active one, else the first, drawn or not; the camera that the
     * active plan would have if all are plans.
     */
    public PerspectiveCamera eye() {
        return Stream.concat(Stream.of(activeView()), views.stream())
                .filter(view -> view.kind() == PaneKind.PERSPECTIVE)
                .findFirst()
                .orElse(activeView())
                .perspective();
    }

    /**
     * Returns the places of the visible panes.
     *
     * @param gap pixels between two panes
     */
    public List<PaneRectangle> rectangles(PaneSize viewport, int gap) {
        int width = viewport.width();
        int height = viewport.height();
        if (isMaximised || arrangement == Arrangement.ONE) {
            return List.of(new PaneRectangle(isMaximised ? active : 0, 0, 0, width, height));
        }
        int left = firstOf(width, columnFraction, gap);
        int right = Math.max(1, width - left - gap);
        if (arrangement == Arrangement.TWO) {
            return List.of(
                    new PaneRectangle(0, 0, 0, left, height), new PaneRectangle(1, left + gap, 0, right, height));
        }
        int upper = firstOf(height, rowFraction, gap);
        int lower = Math.max(1, height - upper - gap);
        return List.of(
                new PaneRectangle(0, 0, 0, left, upper),
                new PaneRectangle(1, left + gap, 0, right, upper),
                new PaneRectangle(2, 0, upper + gap, left, lower),
                new PaneRectangle(3, left + gap, upper + gap, right, lower));
    }

    private static int firstOf(int pixels, double fraction, int gap) {
        return Math.max(1, (int) Math.round((pixels - gap) * fraction));
    }

    /** Returns the pane under a pixel; empty on a gap and outside. */
    public Optional<PaneRectangle> paneAt(double x, double y, PaneSize viewport, int gap) {
        return rectangles(viewport, gap).stream()
                .filter(pane -> pane.contains(x, y))
                .findFirst();
    }

    /** Returns the splitter under a pixel; empty on a pane and outside. */
    public Optional<Splitter> splitterAt(double x, double y, PaneSize viewport, int gap) {
        List<PaneRectangle> panes = rectangles(viewport, gap);
        boolean isInside = x >= 0 && y >= 0 && x < viewport.width() && y < viewport.height();
        if (!isInside || panes.size() == 1) {
            return Optional.empty();
        }
        PaneRectangle first = panes.get(0);
        boolean isColumn = x >= first.width() && x < first.width() + gap;
        boolean isRow = panes.size() == PANES && y >= first.height() && y < first.height() + gap;
        if (isColumn && isRow) {
            return Optional.of(Splitter.BOTH);
        }
        return isColumn ? Optional.of(Splitter.COLUMNS) : isRow ? Optional.of(Splitter.ROWS) : Optional.empty();
    }

    /** Returns this layout with a splitter's middle moved to a pixel. */
    public PaneLayout split(Splitter splitter, double x, double y, PaneSize viewport) {
        double column = splitter == Splitter.ROWS ? columnFraction : x / viewport.width();
        double row = splitter == Splitter.COLUMNS ? rowFraction : y / viewport.height();
        return new PaneLayout(arrangement, active, isMaximised, column, row, views);
    }

    /** Returns this layout with another arrangement, not maximised. */
    public PaneLayout with(Arrangement other) {
        return new PaneLayout(other, active, false, columnFraction, rowFraction, views);
    }

    /** Returns this layout with another active pane. */
    public PaneLayout withActive(int pane) {
        return new PaneLayout(arrangement, pane, isMaximised, columnFraction, rowFraction, views);
    }

    /** Returns this layout with the active pane maximised, or with all panes if it was. */
    public PaneLayout maximiseToggled() {
        return new PaneLayout(arrangement, active, !isMaximised, columnFraction, rowFraction, views);
    }

    /** Returns this layout with another view in a pane. */
    public PaneLayout with(int pane, PaneView view) {
        List<PaneView> others = new ArrayList<>(views);
        others.set(pane, view);
        return new PaneLayout(arrangement, active, isMaximised, columnFraction, rowFraction, others);
    }

    /** Returns this layout with the next kind in the active pane. */
    public PaneLayout cycled() {
        return with(active, activeView().cycled());
    }

    /** Returns this layout with the zoom and the centre of all plans as in the active pane, if that is a plan. */
    public PaneLayout plansLinked() {
        if (activeView().kind() == PaneKind.PERSPECTIVE) {
            return this;
        }
        PlanCamera leader = activeView().plan();
        List<PaneView> others = new ArrayList<>();
        for (PaneView view : views) {
            PlanCamera linked = PlanCamera.linked(view.plan(), leader);
            others.add(new PaneView(view.kind(), view.perspective(), linked, view.mode()));
        }
        return new PaneLayout(arrangement, active, isMaximised, columnFraction, rowFraction, others);
    }
}
