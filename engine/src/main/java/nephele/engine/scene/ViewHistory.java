package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;

/**
 * Where in the picture before this one the same openings were seen, for those that are filled from it. Views are told by
 * where their eyes are before an opening, not by the openings between: the player may have stepped through one since.
 */
public final class ViewHistory {
    /** Of half the picture: a lookup so far beyond an opening's edge still meets its last pixel. */
    private static final double EDGE = 2e-3;

    /** What was cut off by the picture's side is continued from there, if it is not more than this. */
    private static final double LEAST_SHARE = 0.5;

    private final List<ViewNode> matches = new ArrayList<>();
    private final Reprojection reprojection = new Reprojection();
    private ViewTree before;

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
        for (int i = 0; i < now.terminals().size(); i++) {
            matches.add(before == null ? null : best(now.terminals().get(i)));
        }
    }

    /** @return what to take the picture of a terminal opening from, or {@code null} */
    public ViewNode of(ViewNode terminal) {
        return matches.get(terminal.terminal());
    }

    private ViewNode best(ViewNode terminal) {
        ViewNode best = null;
        double bestShare = LEAST_SHARE;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 1; i < before.views().size(); i++) {
            ViewNode shown = before.views().get(i);
            double away =
                    squareDistance(shown.parent().view(), terminal.parent().view());
            double share = shown.opening().isSameAs(terminal.opening()) ? coveredShare(shown, terminal) : 0;
            if (share > bestShare || share == bestShare && away < least) {
                best = shown;
                bestShare = share;
                least = away;
            }
        }
        return best;
    }

    private static double squareDistance(View a, View b) {
        double x = a.eyeX() - b.eyeX();
        double y = a.eyeY() - b.eyeY();
        double z = a.eyeZ() - b.eyeZ();
        return x * x + y * y + z * z;
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
