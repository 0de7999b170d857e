package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;

/**
 * Finds in the picture before this one what fills the openings that the budget does not reach. A view is known by its
 * path: the openings from the eye to it. When the eye has gone through a portal since, the paths of the picture before
 * are taken from the eye's new place.
 */
public final class ViewHistory {
    /** Of half the picture: a lookup so far beyond an opening's edge still meets its last pixel. */
    private static final double EDGE = 2e-3;

    /** What was cut off by the picture's side is continued from there, if it is not more than this. */
    private static final double LEAST_SHARE = 0.5;

    private final List<ViewNode> matches = new ArrayList<>();
    private final Reprojection reprojection = new Reprojection();
    private ViewTree before;
    /** The portal that the eye has gone through since, or {@code null}. */
    private Opening crossed;

    /** Keeps the views of a picture that stays to be looked at; they must not change from now on. */
    public void remember(ViewTree tree) {
        before = tree;
    }

    public void forget() {
        before = null;
        matches.clear();
    }

    public boolean isEmpty() {
        return before == null;
    }

    /** Looks for every terminal opening of {@code now}. */
    public void match(ViewTree now) {
        matches.clear();
        crossed = before == null
                ? null
                : now.openings().crossed(before.root().view(), now.root().view());
        for (int i = 0; i < now.terminals().size(); i++) {
            matches.add(before == null ? null : best(now.terminals().get(i)));
        }
    }

    /** @return what to take the picture of a terminal opening from, or {@code null} */
    public ViewNode of(ViewNode terminal) {
        return matches.get(terminal.terminal());
    }

    /**
     * The view of the same path, or, where that was not drawn either, the nearest one on the path that is seen through the
     * same opening: between facing portals a view looks like the one before it.
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

    /** The drawn view of the picture before that a node's path leads to, or {@code null}. */
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

    /** Of the corners of what shows of {@code terminal}, those that were seen where {@code shown} was. */
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
            covered += shown.region().outside(x, y) <= EDGE ? 1 : 0;
        }
        return covered / (double) seen.size();
    }
}
