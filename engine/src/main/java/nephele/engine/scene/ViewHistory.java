package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;

/**
 * Finds, in the previous picture, contents for the openings that the budget does not reach. A view is identified by its
 * path, the openings from the eye to it. If the eye has passed through a portal since, the paths of the previous
 * picture are taken relative to the eye's new position.
 */
public final class ViewHistory {
    /** Tolerance in units of half the picture: a lookup this far beyond an opening's edge still hits its last pixel. */
    private static final double EDGE_HALF_PICTURES = 2e-3;

    /** The least share of an opening's corners that must have been visible; the rest is extrapolated. */
    private static final double LEAST_SHARE = 0.5;

    private final List<ViewNode> matches = new ArrayList<>();
    private final Reprojection reprojection = new Reprojection();
    private ViewTree before;
    /** The portal that the eye has passed through since, or {@code null}. */
    private Opening crossed;

    /** Keeps the views of the picture that was drawn; they must not change until they are replaced. */
    public void remember(ViewTree tree) {
        before = tree;
    }

    public void forget() {
        before = null;
        matches.clear();
    }

    /** Finds the match of every terminal opening of {@code now}. */
    public void match(ViewTree now) {
        matches.clear();
        crossed = before == null
                ? null
                : now.crossed(before.root().view(), now.root().view());
        for (int i = 0; i < now.terminals().size(); i++) {
            matches.add(before == null ? null : best(now.terminals().get(i)));
        }
    }

    /** Returns the view that supplies the picture for a terminal opening, or {@code null}. */
    public ViewNode of(ViewNode terminal) {
        return matches.get(terminal.terminal());
    }

    /**
     * Returns the view with the same path or, if that was not drawn either, the nearest one on the path that is seen
     * through the same opening: between portals that face each other a view resembles the one before it.
     */
    private ViewNode best(ViewNode terminal) {
        for (ViewNode node = terminal; node.parent() != null; node = node.parent()) {
            ViewNode shown = node.opening().isSameAs(terminal.opening()) ? counterpart(node) : null;
            if (shown != null && shown.parent() != null && coveredShare(shown, terminal) > LEAST_SHARE) {
                return shown;
            }
        }
        return null;
    }

    /** Returns the drawn view of the previous picture with a node's path, or {@code null}. */
    private ViewNode counterpart(ViewNode node) {
        if (node.parent() == null) {
            return crossed == null ? before.root() : drawnChild(before.root(), crossed);
        }
        if (node.depth() == 1 && crossed != null && node.opening().leadsBackThrough(crossed)) {
            return before.root();
        }
        ViewNode parent = counterpart(node.parent());
        return parent == null ? null : drawnChild(parent, node.opening());
    }

    private static ViewNode drawnChild(ViewNode parent, Opening opening) {
        for (int i = 0; i < parent.children().size(); i++) {
            ViewNode child = parent.children().get(i);
            if (!child.isTerminal() && child.opening().isSameAs(opening)) {
                return child;
            }
        }
        return null;
    }

    /**
     * Returns the share of the corners of {@code terminal}'s region that fall into the region of {@code shown}, 0 if
     * one is behind the eye.
     */
    private double coveredShare(ViewNode shown, ViewNode terminal) {
        reprojection.between(terminal.parent().view(), shown.parent().view());
        PicturePolygon seen = terminal.region();
        int covered = 0;
        for (int i = 0; i < seen.size(); i++) {
            double w = reprojection.w(seen.x(i), seen.y(i), seen.w(i));
            double x = reprojection.x(seen.x(i), seen.y(i), seen.w(i)) / w;
            double y = reprojection.y(seen.x(i), seen.y(i), seen.w(i)) / w;
            if (!(w > 0)) {
                return 0;
            }
            covered += shown.region().outside(x, y) <= EDGE_HALF_PICTURES ? 1 : 0;
        }
        return covered / (double) seen.size();
    }
}
