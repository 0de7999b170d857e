package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Frustum;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * One view of a frame's {@link ViewTree}: the main view, or what is seen through an opening in another view. Reused
 * from frame to frame.
 */
public final class ViewNode {
    /**
     * The clipping bounds as a factor on the picture's: the clipped edges must stay outside after rounding to float.
     */
    private static final double BEYOND_PICTURE = 1.05;

    /**
     * In metres: an opening that reaches no farther than this in front of the view's clip plane is in that plane, up to
     * rounding, and faces away.
     */
    private static final double IN_PLANE_METRES = 1e-6;

    /** Directions in the picture along which side planes bound the frustum to the opening. */
    private static final double[][] EIGHT = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};

    /** The near plane as a share of the opening's nearest depth: rasterised corners are up to 1/256 pixel off. */
    private static final double NEAR_SHARE = 0.98;

    private final List<ViewNode> children = new ArrayList<>();
    private final PicturePolygon outline = new PicturePolygon();
    private final PicturePolygon region = new PicturePolygon();
    private final PixelRectangle pixels = new PixelRectangle();
    private final Frustum frustum = Frustum.reusable(EIGHT.length + 2);
    private final Vector3d direction = new Vector3d();
    private final View own = View.reusable();
    private View view;
    private ViewNode parent;
    private Opening opening;
    private int depth;
    private double area;
    private boolean terminal;
    private int number;
    private int terminalIndex;

    /** Returns the view; for a {@link #isTerminal terminal} node the view that would be drawn. */
    public View view() {
        return view;
    }

    /** Returns the view in which this one is seen; {@code null} for the main view. */
    public ViewNode parent() {
        return parent;
    }

    /** Returns the number among all openings of a frame, including terminal ones; 0 for the main view. */
    public int number() {
        return number;
    }

    void number(int newNumber) {
        number = newNumber;
    }

    /** Returns the index among the frame's terminal openings. */
    int terminal() {
        return terminalIndex;
    }

    void terminal(int index) {
        terminalIndex = index;
    }

    /** Returns the opening through which this view is seen; {@code null} for the main view. */
    public Opening opening() {
        return opening;
    }

    /** Returns the number of openings between the eye and this view. */
    public int depth() {
        return depth;
    }

    /** Returns the openings seen in this view, in descending order of area. */
    public List<ViewNode> children() {
        return children;
    }

    /** Returns true if the frame's budget does not reach this view: the opening is filled without drawing it. */
    public boolean isTerminal() {
        return terminal;
    }

    /** Returns the opening in the parent's picture, clipped slightly outside the picture's sides. */
    public PicturePolygon outline() {
        return outline;
    }

    /**
     * Returns a bound of the picture's part that shows this view, given by all openings before it; within the picture.
     */
    public PicturePolygon region() {
        return region;
    }

    /** Returns a rectangle of pixels around the {@link #region}. */
    public PixelRectangle pixels() {
        return pixels;
    }

    /** Returns the frustum that is visible through the openings; it is not set for the main view. */
    public Frustum frustum() {
        return frustum;
    }

    /** Returns the area of the region in pixels. */
    public double area() {
        return area;
    }

    void root(View main, int width, int height) {
        children.clear();
        view = main;
        parent = null;
        opening = null;
        depth = 0;
        terminal = false;
        area = (double) width * height;
        region.clear();
        region.add(-1, -1, 1);
        region.add(1, -1, 1);
        region.add(1, 1, 1);
        region.add(-1, 1, 1);
        pixels.whole(width, height);
    }

    /** Becomes a terminal node for an opening seen in {@code seenIn}; its area is 0 if the opening is not visible. */
    void setOpening(ViewNode seenIn, Opening through, double openness, PixelRectangle picture) {
        children.clear();
        view = null;
        parent = seenIn;
        opening = through;
        depth = seenIn.depth + 1;
        terminal = true;
        area = 0;
        cut(seenIn.view, opening, openness, outline);
        region.copy(outline);
        region.keepWithin(seenIn.region);
        if (!outline.isEmpty() && !region.isEmpty()) {
            area = region.fraction() * picture.width() * picture.height();
            pixels.around(region, picture.width(), picture.height(), seenIn.pixels);
        }
    }

    /** Becomes a drawn view, clipped at the opening's exit plane. */
    void open(ViewTree tree, PixelRectangle picture) {
        look(tree);
        terminal = false;
        setFrustum(picture);
    }

    /** Sets the view behind the opening. */
    void look(ViewTree tree) {
        View before = parent.view;
        Projection projection = tree.pushed(before.projection(), NEAR_SHARE * region.nearest());
        own.setThrough(before, opening, projection);
        view = own;
    }

    private void setFrustum(PixelRectangle picture) {
        frustum.restart(view.eyeX(), view.eyeY(), view.eyeZ());
        Projection projection = view.projection();
        double acrossScale = 1 / projection.tanHalfWidth();
        double upScale = 1 / projection.tanHalfHeight();
        double pixel = 2.0 / Math.min(picture.width(), picture.height());
        for (double[] d : EIGHT) {
            double reach = region.support(d[0], d[1]) + 2 * pixel;
            keepInView(-d[0] * acrossScale, -d[1] * upScale, -reach, 0);
        }
        Plane clip = view.clip();
        frustum.keep(clip.nx(), clip.ny(), clip.nz(), clip.signedDistance(view.eyeX(), view.eyeY(), view.eyeZ()));
        if (projection.farMetres() < Double.POSITIVE_INFINITY) {
            keepInView(0, 0, 1, projection.farMetres());
        }
    }

    /** Keeps a·right + b·up + c·back + d ≥ 0. */
    private void keepInView(double a, double b, double c, double d) {
        view.direction(a, b, c, direction);
        frustum.keep(direction.x, direction.y, direction.z, d);
    }

    /**
     * Fills {@code seen} with the part of an opening that is in front of the view's clip plane, nearer than its far
     * plane and in its picture; empties it if the opening faces away or is not visible.
     *
     * @param openness scale of the opening, 0 to 1
     */
    private static void cut(View view, Opening opening, double openness, PicturePolygon seen) {
        seen.clear();
        if (!(opening.inFront(view.eyeX(), view.eyeY(), view.eyeZ()) > 0) || !(openness > 0)) {
            return;
        }
        Projection projection = view.projection();
        double tanAcross = projection.tanHalfWidth();
        double tanUp = projection.tanHalfHeight();
        for (int i = 0; i < opening.corners(); i++) {
            // Counter-clockwise in the picture, also in a mirrored one.
            int corner = view.isMirrored() ? opening.corners() - 1 - i : i;
            double across = openness * opening.cornerX(corner);
            double upward = openness * opening.cornerY(corner);
            double x = corner(
                    opening.centre().x() - view.eyeX(),
                    opening.frame().right().x(),
                    opening.frame().up().x(),
                    across,
                    upward);
            double y = corner(
                    opening.centre().y() - view.eyeY(),
                    opening.frame().right().y(),
                    opening.frame().up().y(),
                    across,
                    upward);
            double z = corner(
                    opening.centre().z() - view.eyeZ(),
                    opening.frame().right().z(),
                    opening.frame().up().z(),
                    across,
                    upward);
            seen.add(view.alongRight(x, y, z) / tanAcross, view.alongUp(x, y, z) / tanUp, -view.alongBack(x, y, z));
        }
        if (view.clip() != null) {
            if (reachBefore(view.clip(), opening, openness) <= IN_PLANE_METRES) {
                seen.clear();
                return;
            }
            keepBefore(view, view.clip(), seen);
        }
        if (projection.farMetres() < Double.POSITIVE_INFINITY) {
            seen.keepNearer(projection.farMetres());
        }
        seen.keepInPicture(BEYOND_PICTURE);
    }

    /** Returns the greatest signed distance of an opening's corners to a plane, metres. */
    private static double reachBefore(Plane plane, Opening opening, double openness) {
        double alongRight = dot(opening.frame().right(), plane.nx(), plane.ny(), plane.nz());
        double alongUp = dot(opening.frame().up(), plane.nx(), plane.ny(), plane.nz());
        double reach = openness * opening.reach(alongRight, alongUp);
        return plane.signedDistance(opening.centre()) + reach;
    }

    private static double corner(double centre, double right, double up, double across, double upward) {
        return centre + across * right + upward * up;
    }

    private static double dot(Vec3 axis, double x, double y, double z) {
        return axis.x() * x + axis.y() * y + axis.z() * z;
    }

    /**
     * Keeps the part in front of a plane. The plane does not pass through the eye, so its equation in picture
     * coordinates has a constant term.
     */
    private static void keepBefore(View view, Plane plane, PicturePolygon seen) {
        Projection projection = view.projection();
        seen.keep(
                view.alongRight(plane.nx(), plane.ny(), plane.nz()) * projection.tanHalfWidth(),
                view.alongUp(plane.nx(), plane.ny(), plane.nz()) * projection.tanHalfHeight(),
                -view.alongBack(plane.nx(), plane.ny(), plane.nz()),
                plane.signedDistance(view.eyeX(), view.eyeY(), view.eyeZ()));
    }
}
