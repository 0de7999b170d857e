package nephele.engine.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;

/**
 * The views that make up one frame: the main view, the views through its openings, the views through the openings in
 * those, and so on. Views are chosen by covered area, the largest first, until a budget is used up or none covers a
 * pixel; the remaining openings are {@link ViewNode#isTerminal terminal}. An opening is visible from its front only,
 * within the openings before it, and in front of the view's clip plane. One object serves all frames.
 *
 * <p>Openings are the mirrors of a scene, then its open portals. Ids count the mirrors first, so that a new portal changes
 * no mirror's id.
 */
public final class ViewTree {
    /** The greatest depth: the stencil buffer counts to 255. */
    private static final int DEEPEST = 254;

    private static final double LEAST_PIXELS = 1;

    private static final int STEPS_PER_DOUBLE = 16;
    private static final double LOG_2 = Math.log(2);

    private final List<ViewNode> pool = new ArrayList<>();
    private final List<ViewNode> waiting = new ArrayList<>();
    private final List<ViewNode> views = new ArrayList<>();
    private final List<ViewNode> terminals = new ArrayList<>();
    private final PixelRectangle picture = new PixelRectangle();
    /** The main view's projection, and it with the near plane moved away by steps, each made on first use. */
    private Projection main;

    private final Projection[] pushed = new Projection[20 * STEPS_PER_DOUBLE];
    private final List<Opening> mirrors;
    private final List<Opening> openings = new ArrayList<>();
    private Portals portals;
    private FrameState frameState;
    private final View followed = View.reusable();
    private final Vector3d start = new Vector3d();
    private final Vector3d unfolded = new Vector3d();
    private int used;

    /**
     * Makes an empty tree.
     *
     * @param mirrors openings that never change, in the order of their ids, from 0
     */
    public ViewTree(List<Opening> mirrors) {
        this.mirrors = List.copyOf(mirrors);
    }

    /** Returns true if a level has portals or mirrors, or a portal gun. */
    public static boolean mayGrow(Level level) {
        return !level.portals().isEmpty() || level.portalGun() != null || MirrorFaces.any(level);
    }

    /**
     * Builds the tree of a frame of {@code width} by {@code height} pixels.
     *
     * @param budget greatest number of views besides the main view
     */
    public void build(View mainView, FrameState now, int width, int height, int budget) {
        used = 0;
        waiting.clear();
        views.clear();
        terminals.clear();
        picture.whole(width, height);
        if (!mainView.projection().equals(main)) {
            main = mainView.projection();
            Arrays.fill(pushed, null);
        }
        find(now);
        ViewNode root = next();
        root.root(mainView, width, height);
        views.add(root);
        look(root);
        while (!waiting.isEmpty()) {
            ViewNode largest = takeLargest();
            largest.parent().children().add(largest);
            largest.number(views.size() + terminals.size());
            if (views.size() > budget || largest.depth() > DEEPEST) {
                end(largest);
            } else {
                open(largest);
                look(largest);
            }
        }
    }

    private void open(ViewNode node) {
        node.open(this, picture);
        views.add(node);
    }

    /** Ends the tree at a node. Its view is set because the sky is drawn in it. */
    private void end(ViewNode node) {
        node.look(this);
        node.terminal(terminals.size());
        terminals.add(node);
    }

    private void look(ViewNode node) {
        for (int i = 0; i < openings.size(); i++) {
            ViewNode seen = next();
            Opening opening = openings.get(i);
            seen.setOpening(node, opening, openness(opening), picture);
            if (seen.area() >= LEAST_PIXELS
                    && seen.pixels().width() > 0
                    && seen.pixels().height() > 0) {
                waiting.add(seen);
            } else {
                used--;
            }
        }
    }

    /** Removes the largest node, the first among equals, so that a frame does not depend on the order of rounding. */
    private ViewNode takeLargest() {
        int best = 0;
        for (int i = 1; i < waiting.size(); i++) {
            best = waiting.get(i).area() > waiting.get(best).area() ? i : best;
        }
        return waiting.remove(best);
    }

    private ViewNode next() {
        if (used == pool.size()) {
            pool.add(new ViewNode());
        }
        return pool.get(used++);
    }

    /**
     * Returns another view from where its eye would be if it had passed through the same portal as the main one since, so
     * that both see the same behind the same portals; the view itself if the eye has passed through none.
     */
    public View followed(View before) {
        Opening crossed = crossed(before, root().view());
        if (crossed == null) {
            return before;
        }
        followed.setThrough(before, crossed, before.projection());
        return followed;
    }

    /** Returns the main view. */
    public ViewNode root() {
        return views.get(0);
    }

    /** Returns the views to draw, the main view first, every view after its parent. */
    public List<ViewNode> views() {
        return views;
    }

    /** Returns the openings that the budget does not reach. */
    public List<ViewNode> terminals() {
        return terminals;
    }

    /** Finds the openings of a frame state. */
    private void find(FrameState now) {
        frameState = now;
        if (portals == now.portals()) {
            return;
        }
        portals = now.portals();
        openings.clear();
        openings.addAll(mirrors);
        for (int i = 0; i < portals.size(); i++) {
            if (portals.isOpen(i)) {
                openings.add(Opening.ofPortal(mirrors.size() + i, portals, i));
            }
        }
    }

    /**
     * Returns the portal through which an eye has moved on a straight path from one view to another, or {@code null}:
     * of the portals that such a path passes, the one with the shortest path, if that is shorter than the path through
     * none.
     */
    Opening crossed(View from, View to) {
        start.set(from.eyeX(), from.eyeY(), from.eyeZ());
        double shortest = start.distance(to.eyeX(), to.eyeY(), to.eyeZ());
        Opening crossed = null;
        for (int i = mirrors.size(); i < openings.size(); i++) {
            Opening portal = openings.get(i);
            PortalTransform back = portals.transform(portals.partner(portal.portal()));
            if (back != null) {
                back.point(unfolded.set(to.eyeX(), to.eyeY(), to.eyeZ()));
                double metres = start.distance(unfolded);
                if (metres < shortest && portal.isPassed(start, unfolded)) {
                    shortest = metres;
                    crossed = portal;
                }
            }
        }
        return crossed;
    }

    /** Returns the scale at which an opening is open now, 0 to 1: a new portal grows. */
    private double openness(Opening opening) {
        return opening.portal() == Opening.NO_PORTAL ? 1 : frameState.openness(opening.portal());
    }

    /**
     * Returns the projection of a view through an opening: the frame's own projection with its near plane moved away, to
     * the greatest step not beyond {@code metres}, or {@code before} if that has its near plane at least as far away. There
     * are 16 steps per doubling, so that each projection is made once and reused in later frames.
     */
    Projection pushed(Projection before, double metres) {
        double doubles = Math.log(metres / main.nearMetres()) / LOG_2;
        int step = (int) Math.floor(Math.min(doubles * STEPS_PER_DOUBLE, pushed.length - 1));
        if (step <= 0 || atStep(step).nearMetres() <= before.nearMetres()) {
            return before;
        }
        return atStep(step);
    }

    private Projection atStep(int step) {
        if (pushed[step] == null) {
            double near = main.nearMetres() * Math.pow(2, step / (double) STEPS_PER_DOUBLE);
            pushed[step] = new Projection(main.verticalFovRadians(), main.aspect(), near, main.farMetres());
        }
        return pushed[step];
    }
}
