package nephele.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import nephele.engine.level.PortalShape;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.junit.jupiter.api.Test;

/** The tree chooses the largest views and clips their openings exactly. */
class ViewTreeTest {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 720;
    private static final Vec3 UP = new Vec3(0, 1, 0);

    private static Portal portal(Vec3 centre, Vec3 normal) {
        return portal(centre, normal, 2, 2, PortalShape.RECTANGLE);
    }

    private static Portal portal(Vec3 centre, Vec3 normal, double width, double height, PortalShape shape) {
        return new Portal("p", centre, Portal.facing(normal, UP), Aperture.of(shape, width, height));
    }

    /** Returns a frame state in which successive portals are partners. */
    private static FrameState pairs(Portal... portals) {
        List<Integer> partners = new ArrayList<>();
        for (int i = 0; i < portals.length; i++) {
            partners.add(i ^ 1);
        }
        FrameState frameState = FrameState.atStart(new TestLevel().level());
        frameState.portals(new Portals(List.of(portals), partners));
        return frameState;
    }

    private static View view(Vec3 eye, Vec3 target) {
        return View.lookAt(eye, target, UP, new Projection(1, WIDTH / (double) HEIGHT, 0.05, 1000));
    }

    private static ViewTree grown(View view, FrameState frameState, int budget) {
        ViewTree tree = new ViewTree(List.of());
        tree.build(view, frameState, WIDTH, HEIGHT, budget);
        return tree;
    }

    private static FrameState facing(double apart) {
        return pairs(
                portal(new Vec3(0, 0, -apart / 2), new Vec3(0, 0, 1)),
                portal(new Vec3(0, 0, apart / 2), new Vec3(0, 0, -1)));
    }

    /** A portal's own rear is not visible, neither from behind nor through itself. */
    @Test
    void aPortalIsNotSeenFromBehind() {
        FrameState frameState =
                pairs(portal(Vec3.ZERO, new Vec3(0, 0, 1)), portal(new Vec3(0, 0, -5), new Vec3(0, 0, 1)));
        assertEquals(
                1,
                grown(view(new Vec3(0.2, 0, -3), new Vec3(0, 0, 0)), frameState, 50)
                        .views()
                        .size());
        ViewTree front = grown(view(new Vec3(0.2, 0, 3), new Vec3(0, 0, 0)), frameState, 50);
        assertTrue(front.views().size() > 1);
        for (ViewNode node : front.views()) {
            if (node.parent() != null) {
                Portal seen = frameState.portals().portal(node.opening().portal());
                Vec3 eye = node.parent().view().eye();
                assertTrue(seen.inFront(eye.x(), eye.y(), eye.z()) > 0);
            }
        }
    }

    /** A portal entirely behind a view's clip plane is not drawn. */
    @Test
    void aPortalBehindTheClipPlaneIsNotSeen() {
        Portal entry = portal(Vec3.ZERO, new Vec3(0, 0, 1));
        Portal exit = portal(new Vec3(100, 0, 0), new Vec3(0, 0, 1));
        // Both face the entry's virtual eye at (100, 0, −4); one is in front of the exit's plane, the other behind it.
        Portal before = portal(new Vec3(100, 0, 2), new Vec3(0, 0, -1), 0.5, 0.5, PortalShape.RECTANGLE);
        Portal behind = portal(new Vec3(100, 0, -2), new Vec3(0, 0, -1), 0.5, 0.5, PortalShape.RECTANGLE);
        Portal elsewhere = portal(new Vec3(0, 500, 0), new Vec3(0, 1, 0.1));
        View view = view(new Vec3(0, 0, 4), Vec3.ZERO);
        assertEquals(
                3,
                grown(view, pairs(entry, exit, before, elsewhere), 50).views().size());
        assertEquals(
                2,
                grown(view, pairs(entry, exit, behind, elsewhere), 50).views().size());
    }

    /** The number of views equals the budget with 64 portals that all see each other. */
    @Test
    void theBudgetHoldsWithSixtyFourPortals() {
        Random random = new Random(21);
        Portal[] portals = new Portal[64];
        for (int i = 0; i < portals.length; i++) {
            double angle = 2 * Math.PI * i / portals.length;
            Vec3 centre = new Vec3(8 * Math.cos(angle), 0.3 * random.nextDouble(), 8 * Math.sin(angle));
            portals[i] = portal(centre, new Vec3(-centre.x(), 0, -centre.z()), 0.7, 2, PortalShape.ARCH);
        }
        FrameState frameState = pairs(portals);
        for (int budget : new int[] {0, 1, 12, 32, 254}) {
            ViewTree tree = grown(view(new Vec3(0.1, 0, 0), new Vec3(1, 0, 0.2)), frameState, budget);
            assertEquals(budget + 1, tree.views().size());
            assertTrue(!tree.terminals().isEmpty());
        }
    }

    /** Every drawn view covers at least as many pixels as any remaining opening. */
    @Test
    void theLargestViewsAreChosen() {
        for (int budget = 1; budget < 20; budget++) {
            ViewTree tree = grown(view(new Vec3(0.4, 0.2, 1), new Vec3(0, 0, -2.5)), facing(5), budget);
            double least =
                    tree.views().stream().mapToDouble(ViewNode::area).min().orElseThrow();
            double most =
                    tree.terminals().stream().mapToDouble(ViewNode::area).max().orElse(0);
            assertTrue(least >= most, budget + ": " + least + " " + most);
        }
    }

    /** An eye 1e-9 m in front of the plane sees only the opening; along the plane, it fills half the picture. */
    @Test
    void anEyeAtThePlaneSeesNothingButTheView() {
        FrameState frameState = pairs(
                portal(Vec3.ZERO, new Vec3(0, 0, 1), 1.2, 2.1, PortalShape.ARCH),
                portal(new Vec3(50, 0, 0), new Vec3(1, 0, 0), 1.2, 2.1, PortalShape.ARCH));
        for (double metres : new double[] {1e-1, 1e-3, 1e-6, 1e-9, 1e-12}) {
            View straight = view(new Vec3(0.1, -0.2, metres), new Vec3(0.1, -0.2, -1));
            ViewNode seen = grown(straight, frameState, 1).views().get(1);
            double whole = metres > 0.05 ? 0.9 : 1;
            assertTrue(seen.area() >= whole * WIDTH * HEIGHT * (1 - 1e-9), metres + ": " + seen.area());
            assertEquals(0.05, seen.view().projection().nearMetres(), metres > 0.05 ? 0.06 : 0);
        }
        // The eye looks along the plane: its line divides the picture in the middle, and the opening fills one half.
        View along = view(new Vec3(-0.3, 0, 1e-9), new Vec3(1, 0, 1e-9));
        assertEquals(
                0.5 * WIDTH * HEIGHT, grown(along, frameState, 1).views().get(1).area(), 2);
    }

    /** The area of an unclipped opening equals that of its corners projected one by one. */
    @Test
    void areasAreThoseOfTheProjectedPolygon() {
        Random random = new Random(5);
        for (int i = 0; i < 200; i++) {
            Portal entry = portal(Vec3.ZERO, new Vec3(0, 0, 1), 1, 1.6, PortalShape.values()[i % 3]);
            Vec3 eye = new Vec3(2 * random.nextDouble() - 1, random.nextDouble() - 0.5, 3 + random.nextDouble());
            View view = view(eye, new Vec3(0.1, 0.1, 0));
            FrameState frameState = pairs(entry, portal(new Vec3(90, 0, 0), new Vec3(0, 1, 0.2)));
            assertEquals(
                    projectedArea(entry, view),
                    grown(view, frameState, 1).views().get(1).area(),
                    1e-6);
        }
    }

    private static double projectedArea(Portal portal, View view) {
        double twice = 0;
        int corners = portal.aperture().corners();
        for (int i = 0; i < corners; i++) {
            double[] a = pixel(portal, i, view);
            double[] b = pixel(portal, (i + 1) % corners, view);
            twice += a[0] * b[1] - a[1] * b[0];
        }
        return twice / 2;
    }

    private static double[] pixel(Portal portal, int corner, View view) {
        Vec3 p = portal.world(
                portal.aperture().cornerX(corner), portal.aperture().cornerY(corner), 0);
        var clip = view.clipFromRelative(new org.joml.Matrix4d())
                .transform(new org.joml.Vector4d(
                        p.x() - view.eye().x(),
                        p.y() - view.eye().y(),
                        p.z() - view.eye().z(),
                        1));
        return new double[] {(clip.x / clip.w + 1) / 2 * WIDTH, (clip.y / clip.w + 1) / 2 * HEIGHT};
    }

    /** Regions are nested, pixel rectangles contain them, and near planes do not come nearer. */
    @Test
    void whatIsSeenThroughAViewLiesWithinIt() {
        ViewTree tree = grown(view(new Vec3(0.4, 0.2, 1), new Vec3(0, 0, -2.5)), facing(5), 100);
        assertTrue(tree.views().size() > 10);
        for (ViewNode node : tree.views().subList(1, tree.views().size())) {
            assertTrue(node.area() <= node.parent().area());
            for (int i = 0; i < node.region().size(); i++) {
                double x = node.region().x(i) / node.region().w(i);
                double y = node.region().y(i) / node.region().w(i);
                assertTrue(node.parent().region().outside(x, y) < 1e-9);
                double column = (x + 1) / 2 * WIDTH;
                assertTrue(column >= node.pixels().x()
                        && column <= node.pixels().x() + node.pixels().width());
            }
            assertTrue(node.view().projection().nearMetres()
                    >= node.parent().view().projection().nearMetres());
        }
    }

    /** An opening's size is proportional to the portal's openness; a portal without a partner is no opening. */
    @Test
    void anOpeningGrowsAsThePortalOpens() {
        FrameState frameState = facing(5);
        View view = view(new Vec3(0, 0, 1), new Vec3(0, 0, -2.5));
        double whole = grown(view, frameState, 1).views().get(1).area();
        frameState.setPortalLook(0, 0, 0.5);
        assertEquals(whole / 4, grown(view, frameState, 1).views().get(1).area(), 1e-6 * whole);
        frameState.setPortalLook(0, 0, 0);
        assertEquals(1, grown(view, frameState, 1).views().size());
        frameState.portals(new Portals(
                List.of(frameState.portals().portal(0), frameState.portals().portal(1)),
                List.of(Portals.CLOSED, Portals.CLOSED)));
        assertEquals(1, grown(view, frameState, 1).views().size());
    }

    /** An opening beyond the far plane is not drawn; one that extends beyond it is clipped there. */
    @Test
    void anOpeningEndsAtTheFarPlane() {
        View near = View.lookAt(Vec3.ZERO, new Vec3(0, 0, -1), UP, new Projection(1, 16 / 9.0, 0.05, 10));
        Portal elsewhere = portal(new Vec3(0, 0, 90), new Vec3(0, 0, 1));
        FrameState beyond = pairs(portal(new Vec3(0, 0, -11), new Vec3(0, 0, 1)), elsewhere);
        assertEquals(1, grown(near, beyond, 9).views().size());
        FrameState along =
                pairs(portal(new Vec3(-1, 0, -10), new Vec3(1, 0, 0), 4, 2, PortalShape.RECTANGLE), elsewhere);
        ViewNode opening = grown(near, along, 9).root().children().get(0);
        double farthest = 0;
        for (int i = 0; i < opening.outline().size(); i++) {
            farthest = Math.max(farthest, opening.outline().w(i));
        }
        assertEquals(10, farthest, 1e-12);
    }

    /** Equally large openings are ordered by portal, independent of earlier choices. */
    @Test
    void equallyLargeOpeningsKeepTheirOrder() {
        Portal small = portal(new Vec3(3, 0, -5), new Vec3(0, 0, 1), 1, 1, PortalShape.RECTANGLE);
        Portal elsewhere = portal(new Vec3(0, 0, 90), new Vec3(0, 0, 1));
        Portal large = portal(new Vec3(-2, 0, -5), new Vec3(0, 0, 1));
        FrameState frameState = pairs(large, elsewhere, small, elsewhere, small, elsewhere, small, elsewhere);
        ViewTree tree = grown(view(Vec3.ZERO, new Vec3(0, 0, -1)), frameState, 50);
        assertEquals(
                List.of(0, 2, 4, 6),
                tree.root().children().stream()
                        .map(node -> node.opening().portal())
                        .toList());
    }

    /** A portal with another shape or size has no history, even at the same position. */
    @Test
    void aPortalOfAnotherApertureHasNoHistory() {
        View view = view(new Vec3(0.4, 0.2, -2.4), new Vec3(0.4, 0.2, -5));
        ViewTree before = grown(view, facing(5), 6);
        for (PortalShape shape : PortalShape.values()) {
            for (double width : new double[] {2, 1.9}) {
                FrameState frameState = pairs(
                        portal(new Vec3(0, 0, -2.5), new Vec3(0, 0, 1), width, 2, shape),
                        portal(new Vec3(0, 0, 2.5), new Vec3(0, 0, -1), width, 2, shape));
                ViewTree now = grown(view, frameState, 5);
                ViewHistory history = new ViewHistory();
                history.remember(before);
                history.match(now);
                boolean isSame = shape == PortalShape.RECTANGLE && width == 2;
                assertEquals(isSame, history.of(now.terminals().get(0)) != null, shape + " " + width);
            }
        }
    }

    /** History is found by the path from the eye, also after the eye has passed through a portal. */
    @Test
    void historyIsFoundByThePathFromTheEye() {
        FrameState frameState = facing(5);
        ViewTree before = grown(view(new Vec3(0.4, 0.2, -2.4), new Vec3(0.4, 0.2, -5)), frameState, 6);
        ViewTree stepped = grown(view(new Vec3(0.4, 0.2, 2.4), new Vec3(0.4, 0.2, -5)), frameState, 5);
        ViewHistory history = new ViewHistory();
        history.match(stepped);
        assertSame(null, history.of(stepped.terminals().get(0)));
        history.remember(before);
        history.match(stepped);
        ViewNode terminal = stepped.terminals().get(0);
        ViewNode match = history.of(terminal);
        // The eyes are 5 m apart: the terminal's is at 27.4 m, the last one that was drawn before at 22.6 m.
        assertEquals(27.4, terminal.parent().view().eye().z(), 1e-9);
        assertEquals(22.6, match.parent().view().eye().z(), 1e-9);
        history.forget();
        history.match(stepped);
        assertSame(null, history.of(terminal));
    }
}
