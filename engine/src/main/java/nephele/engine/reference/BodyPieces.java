package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import org.joml.Matrix3d;
import org.joml.Vector3d;

/**
 * The bodies of a level at their initial positions. A body that reaches through portals consists of several pieces: the
 * body, cut by the planes of all of these portals, and behind each its image, cut by the exit's plane.
 */
final class BodyPieces {
    private BodyPieces() {}

    static List<BodyPiece> of(Level level, Portals portals) {
        List<BodyPiece> pieces = new ArrayList<>();
        for (int i = 0; i < level.bodies().size(); i++) {
            Body body = level.bodies().get(i);
            add(new BodyPiece(i, BodyShape.of(body), body.centre(), new Matrix3d(), List.of()), portals, pieces);
        }
        return pieces;
    }

    private static void add(BodyPiece whole, Portals portals, List<BodyPiece> pieces) {
        List<Plane> cuts = new ArrayList<>();
        for (int i = 0; i < portals.size(); i++) {
            if (portals.isOpen(i) && reachesThrough(whole, portals.portal(i))) {
                cuts.add(portals.plane(i));
                pieces.add(image(whole, portals.transform(i), portals.plane(portals.partner(i))));
            }
        }
        pieces.add(new BodyPiece(whole.body(), whole.form(), whole.centre(), whole.worldFromBody(), cuts));
    }

    private static BodyPiece image(BodyPiece whole, PortalTransform transform, Plane exit) {
        Matrix3d worldFromBody = new Matrix3d(transform.rotation()).mul(whole.worldFromBody());
        return new BodyPiece(whole.body(), whole.form(), transform.point(whole.centre()), worldFromBody, List.of(exit));
    }

    /**
     * Returns true if the body's centre is in front of the portal, a part of it is behind, and no edge of the aperture
     * separates it from the aperture.
     */
    private static boolean reachesThrough(BodyPiece body, Portal portal) {
        Vec3 c = body.centre();
        Vec3 n = portal.normal();
        double height = portal.inFront(c.x(), c.y(), c.z());
        if (height < 0 || body.reach(n.x(), n.y(), n.z()) <= height) {
            return false;
        }
        Aperture aperture = portal.aperture();
        double x = portal.across(c.x(), c.y(), c.z());
        double y = portal.upward(c.x(), c.y(), c.z());
        for (int i = 0; i < aperture.corners(); i++) {
            Vector3d out = portal.frame()
                    .right()
                    .toVector()
                    .mul(aperture.edgeNormalX(i))
                    .fma(aperture.edgeNormalY(i), portal.frame().up().toVector());
            double outside = aperture.edgeNormalX(i) * x + aperture.edgeNormalY(i) * y - aperture.edgeDistance(i);
            if (outside >= body.reach(out.x, out.y, out.z)) {
                return false;
            }
        }
        return true;
    }
}
