package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.MirrorFaces;

/**
 * Which views make up one frame: the picture itself, what its openings show, what the openings in those show, and so on.
 * Views are chosen by the pixels they cover, the largest first, until a budget is used up or none covers a pixel; the
 * openings that are left are {@link ViewNode#isTerminal terminal}. An opening is seen from in front only, within the
 * openings before it, and before the plane that cuts the view. One object serves frame after frame.
 */
public final class ViewTree {
    /** A stencil counts to 255. */
    private static final int DEEPEST = 254;

    private static final double LEAST_PIXELS = 1;

    private final List<ViewNode> pool = new ArrayList<>();
    private final List<ViewNode> waiting = new ArrayList<>();
    private final List<ViewNode> views = new ArrayList<>();
    private final List<ViewNode> terminals = new ArrayList<>();
    private final PixelRectangle picture = new PixelRectangle();
    private final Projections projections = new Projections();
    private final Openings openings;
    private int used;

    /** @param mirrors openings that never change */
    public ViewTree(List<Opening> mirrors) {
        openings = new Openings(mirrors);
    }

    /** Whether a level has portals or mirrors, or lets the player open portals. */
    public static boolean mayGrow(Level level) {
        return !level.portals().isEmpty() || level.portalGun() != null || MirrorFaces.any(level);
    }

    /** @param budget views beside the picture itself, at most */
    public void grow(View main, Moment moment, int width, int height, int budget) {
        used = 0;
        waiting.clear();
        views.clear();
        terminals.clear();
        picture.whole(width, height);
        projections.begin(main.projection());
        openings.at(moment);
        ViewNode root = next();
        root.root(main, width, height);
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
        node.open(projections, picture);
        views.add(node);
    }

    /** Its sky is all that can be drawn of it. */
    private void end(ViewNode node) {
        node.look(projections);
        node.terminal(terminals.size());
        terminals.add(node);
    }

    private void look(ViewNode node) {
        for (int i = 0; i < openings.size(); i++) {
            ViewNode seen = next();
            Opening opening = openings.get(i);
            seen.candidate(node, opening, openings.openness(opening), picture);
            if (seen.area() >= LEAST_PIXELS
                    && seen.pixels().width() > 0
                    && seen.pixels().height() > 0) {
                waiting.add(seen);
            } else {
                used--;
            }
        }
    }

    /** The first among equally large ones, so that a frame does not depend on rounding of the order. */
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

    Openings openings() {
        return openings;
    }

    /** The picture itself. */
    public ViewNode root() {
        return views.get(0);
    }

    /** All that are to be drawn, the picture itself first, every one after the one it is seen in. */
    public List<ViewNode> views() {
        return views;
    }

    /** Openings that the budget does not reach. */
    public List<ViewNode> terminals() {
        return terminals;
    }
}
