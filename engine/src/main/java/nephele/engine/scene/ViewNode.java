package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Frustum;
import nephele.engine.math.Plane;
import org.joml.Vector3d;

/**
 * One view of a frame's {@link ViewTree}: the picture itself, or what is seen through an opening in another view. Reused
 * from frame to frame.
 */
public final class ViewNode {
    /** Directions of the picture in which the frustum is as narrow as the opening; the other four are opposite. */
    private static final double[][] EIGHT = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};

    /** Of the nearest depth in the opening: rasterised corners lie up to 1/256 pixel off. */
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

    /** What is seen here; of a {@link #isTerminal terminal} node what would be. */
    public View view() {
        return view;
    }

    /** In whose picture this one is seen; {@code null} for the picture itself. */
    public ViewNode parent() {
        return parent;
    }

    /** Counts the openings of a frame, terminal ones too; 0 for the picture itself. */
    public int number() {
        return number;
    }

    void number(int newNumber) {
        number = newNumber;
    }

    /** Which of the frame's terminal openings this is. */
    int terminal() {
        return terminalIndex;
    }

    void terminal(int index) {
        terminalIndex = index;
    }

    /** Through what this is seen; {@code null} for the picture itself. */
    public Opening opening() {
        return opening;
    }

    /** Openings between the eye and this view. */
    public int depth() {
        return depth;
    }

    /** Openings that are seen in this view, the larger ones first. */
    public List<ViewNode> children() {
        return children;
    }

    /** Whether the frame's budget ends here: the opening is to be filled without drawing what is behind it. */
    public boolean isTerminal() {
        return terminal;
    }

    /** The opening as the parent's projection has it, cut by little more than the picture's sides. */
    public PicturePolygon outline() {
        return outline;
    }

    /** What of the picture shows this view at most, by the openings before it; in the picture's sides. */
    public PicturePolygon region() {
        return region;
    }

    /** Pixels around the {@link #region}. */
    public PixelRectangle pixels() {
        return pixels;
    }

    /** What may be seen through the openings; for the picture itself nothing is in here. */
    public Frustum frustum() {
        return frustum;
    }

    /** Pixels that the region covers. */
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

    /** Makes this what {@code seenIn} shows of an opening, if it shows any of it. */
    void candidate(ViewNode seenIn, Opening through, double openness, PixelRectangle picture) {
        children.clear();
        view = null;
        parent = seenIn;
        opening = through;
        depth = seenIn.depth + 1;
        terminal = true;
        area = 0;
        OpeningCutter.cut(seenIn.view, opening, openness, outline);
        region.copy(outline);
        region.keepWithin(seenIn.region);
        if (!outline.isEmpty() && !region.isEmpty()) {
            area = region.share() * picture.width() * picture.height();
            pixels.around(region, picture.width(), picture.height(), seenIn.pixels);
        }
    }

    /** Makes this a view of its own, from behind the plane that the opening leads to. */
    void open(Projections projections, PixelRectangle picture) {
        look(projections);
        terminal = false;
        narrow(picture);
    }

    /** Looks from behind the plane that the opening leads to. */
    void look(Projections projections) {
        View before = parent.view;
        Projection projection = projections.pushed(before.projection(), NEAR_SHARE * region.nearest());
        own.carry(before, opening, projection);
        view = own;
    }

    private void narrow(PixelRectangle picture) {
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

    /** Keeps a·right + b·up + c·back + d not negative. */
    private void keepInView(double a, double b, double c, double d) {
        view.direction(a, b, c, direction);
        frustum.keep(direction.x, direction.y, direction.z, d);
    }
}
