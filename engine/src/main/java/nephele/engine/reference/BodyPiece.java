package nephele.engine.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Ray;
import nephele.engine.math.RayClip;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.engine.reference.BodyShape.Span;
import org.joml.Matrix3d;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * A body at its position, or its image behind a portal that it reaches through.
 *
 * @param body index in the level
 * @param cuts only the part in front of all these planes exists
 */
record BodyPiece(int body, BodyShape form, Vec3 centre, Matrix3d worldFromBody, List<Plane> cuts)
        implements TracedShape {
    /** Returns infinity also for a ray that enters through a cut. */
    @Override
    public double entry(Ray ray, double least, double most) {
        Span inside = span(ray);
        if (!(inside.enter() < inside.leave() && inside.enter() >= least)) {
            return Double.POSITIVE_INFINITY;
        }
        Vec3 place = ray.at(inside.enter());
        return cuts.stream().allMatch(cut -> cut.signedDistance(place) >= 0)
                ? inside.enter()
                : Double.POSITIVE_INFINITY;
    }

    @Override
    public boolean intersects(Ray ray, double limit) {
        Span inside = span(ray);
        RayClip clip = new RayClip(ray, Math.max(inside.enter(), 0), Math.min(inside.leave(), limit));
        cuts.forEach(clip::keepInFront);
        return clip.enter() <= clip.leave();
    }

    @Override
    public boolean shadesItself() {
        return false;
    }

    @Override
    public SurfacePoint at(EyePath path, Vec3 place, Vector3dc toEye, SurfaceAppearance looks) {
        return looks.bodies().at(path.item(), this, place, toEye);
    }

    @Override
    public EmissiveSurfaces.Emitter emitter(int item, SurfaceAppearance looks) {
        Vec3 radiance = looks.bodies().emission(body);
        double density = EmissiveSurfaces.brightness(radiance);
        return density == 0 ? null : new Lit(this, radiance, density);
    }

    /** The light of a body, from evenly chosen places of all its surface. */
    private record Lit(BodyPiece piece, Vec3 radiance, double density) implements EmissiveSurfaces.Emitter {
        @Override
        public double power() {
            return piece.form.squareMetres() * density;
        }

        @Override
        public EmissiveSurfaces.Source source(SplittableRandom random) {
            Vector3d local = piece.form.place(random);
            Vector3d normal = piece.worldFromBody.transform(piece.form.normal(local));
            Vec3 place = piece.centre.plus(Vec3.of(piece.worldFromBody.transform(local)));
            boolean isCut = piece.cuts.stream().anyMatch(cut -> cut.signedDistance(place) < 0);
            return isCut ? null : new EmissiveSurfaces.Source(place, Vec3.of(normal), radiance, density);
        }

        @Override
        public double density(EyePath path) {
            return density;
        }
    }

    private Span span(Ray ray) {
        Vector3d origin = local(new Vec3(ray.originX(), ray.originY(), ray.originZ()));
        Vector3d direction =
                worldFromBody.transformTranspose(new Vector3d(ray.directionX(), ray.directionY(), ray.directionZ()));
        return form.span(origin, direction);
    }

    /** Maps a position in the world to the body's own frame. */
    Vector3d local(Vec3 world) {
        Vector3d p = world.toVector().sub(centre.x(), centre.y(), centre.z());
        return worldFromBody.transformTranspose(p);
    }

    /** Returns the extent from its centre along a unit direction of the world, ignoring cuts. */
    double reach(double x, double y, double z) {
        return form.reach(worldFromBody.transformTranspose(new Vector3d(x, y, z)));
    }

    @Override
    public Aabb bounds() {
        return Aabb.around(centre, new Vec3(2 * reach(1, 0, 0), 2 * reach(0, 1, 0), 2 * reach(0, 0, 1)));
    }

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
