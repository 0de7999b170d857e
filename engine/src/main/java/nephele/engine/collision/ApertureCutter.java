package nephele.engine.collision;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.portal.Portal;
import nephele.engine.portal.PortalTransform;
import nephele.engine.portal.Portals;
import nephele.engine.portal.ground.GroundSeat;

/**
 * Cuts solids at the apertures and puts the other side's solids into the aperture volumes. The other side may have
 * portals within reach; when two portals face each other, one of them is the entry itself. They are opened in turn,
 * each as far as the remaining reach goes, up to {@link #MOST_DEPTH} behind one another; farther ones are closed.
 */
final class ApertureCutter {
    /** Upper bound of the distance of a body's parts from its centre. */
    static final double REACH_METRES = 2.5;

    private static final int MOST_DEPTH = 3;
    /** Least remaining reach with which a further portal is opened. */
    private static final double LEAST_REACH_METRES = 0.05;

    private final CollisionWorld statics;
    private final Portals portals;
    /** The height of each portal above the ground around it, {@link GroundSeat#stepMetres}; NaN before it is asked for. */
    private final double[] groundSteps;

    private final ItemList found = new ItemList();

    ApertureCutter(CollisionWorld statics, Portals portals) {
        this.statics = statics;
        this.portals = portals;
        groundSteps = new double[portals.size()];
        Arrays.fill(groundSteps, Double.NaN);
    }

    /** A convex part of a solid. */
    private record Piece(String solidId, boolean isGround, ConvexPolyhedron shape) {
        Piece with(ConvexPolyhedron part) {
            return new Piece(solidId, isGround, part);
        }
    }

    /** Returns the static world with these portals open. */
    CollisionWorld open(long mask) {
        List<ApertureVolume> openings = openings(mask, REACH_METRES, portals.size());
        ItemList cut = new ItemList();
        List<Piece> pieces = new ArrayList<>();
        for (int item : touched(openings)) {
            Piece whole = piece(item);
            List<Piece> left = carved(List.of(whole), openings);
            if (!isUnchanged(whole, left)) {
                cut.accept(item);
                pieces.addAll(left);
            }
        }
        for (ApertureVolume opening : openings) {
            pieces.addAll(otherSide(opening, opening.bounds(), MOST_DEPTH));
        }
        List<Collider> colliders = new ArrayList<>();
        pieces.forEach(piece -> colliders.add(new Collider(piece.solidId(), piece.shape())));
        return statics.replacing(cut, colliders);
    }

    /** Returns how far the ground around a portal lies below it, found on the first call. */
    double groundStepMetres(int portal) {
        if (Double.isNaN(groundSteps[portal])) {
            groundSteps[portal] = GroundSeat.stepMetres(statics.grounds(), portals.portal(portal));
        }
        return groundSteps[portal];
    }

    private Piece piece(int item) {
        Collider solid = statics.collider(item);
        return new Piece(solid.solidId(), statics.isGround(item), solid.shape());
    }

    private static boolean isUnchanged(Piece whole, List<Piece> left) {
        return left.size() == 1 && left.get(0).shape() == whole.shape();
    }

    private int[] touched(List<ApertureVolume> openings) {
        return openings.stream()
                .flatMapToInt(opening -> within(opening.bounds()))
                .distinct()
                .sorted()
                .toArray();
    }

    private IntStream within(Aabb box) {
        statics.overlapping(box, found);
        int[] items = new int[found.size()];
        for (int i = 0; i < items.length; i++) {
            items[i] = found.get(i);
        }
        return Arrays.stream(items);
    }

    /**
     * Returns the volumes of the portals that are open here.
     *
     * @param from the portal from which the reach is measured, or any index from the number of portals on for none
     */
    private List<ApertureVolume> openings(long mask, double reachMetres, int from) {
        List<ApertureVolume> openings = new ArrayList<>();
        for (int i = 0; i < portals.size(); i++) {
            if (isIn(mask, i)) {
                double reach = reachMetres - (from < portals.size() ? distance(from, i) : 0);
                List<Plane> shared = new ArrayList<>();
                for (int j = 0; j < portals.size(); j++) {
                    Plane plane = j != i && isIn(mask, j)
                            ? ApertureVolume.dividing(portals.portal(i), portals.portal(j))
                            : null;
                    if (plane != null) {
                        shared.add(plane);
                    }
                }
                openings.add(new ApertureVolume(i, portals.portal(i), reach, groundStepMetres(i), shared));
            }
        }
        return openings;
    }

    private static boolean isIn(long mask, int portal) {
        return portal < Long.SIZE && (mask & 1L << portal) != 0;
    }

    private static List<Piece> carved(List<Piece> pieces, List<ApertureVolume> openings) {
        List<Piece> rest = pieces;
        for (ApertureVolume opening : openings) {
            List<Piece> left = new ArrayList<>();
            for (Piece piece : rest) {
                if (piece.shape().bounds().overlaps(opening.bounds())) {
                    List<ConvexPolyhedron> shapes = new ArrayList<>();
                    if (piece.isGround()) {
                        opening.carveGround(piece.shape(), shapes);
                    } else {
                        opening.carve(piece.shape(), shapes);
                    }
                    shapes.forEach(shape -> left.add(piece.with(shape)));
                } else {
                    left.add(piece);
                }
            }
            rest = left;
        }
        return rest;
    }

    /** Returns the solids beyond an opening, moved behind it, as far as they touch the box. */
    private List<Piece> otherSide(ApertureVolume opening, Aabb box, int depth) {
        int partner = portals.partner(opening.portal());
        Aabb beyond = moved(box, portals.transform(opening.portal()));
        long inner = depth > 0 ? reached(partner, opening.reachMetres()) : 0;
        List<ApertureVolume> further = openings(inner, opening.reachMetres(), partner);
        List<Piece> pieces = new ArrayList<>();
        within(beyond).mapToObj(this::piece).forEach(pieces::add);
        List<Piece> there = new ArrayList<>(carved(pieces, further));
        for (ApertureVolume next : further) {
            if (next.bounds().overlaps(beyond)) {
                there.addAll(otherSide(next, next.bounds(), depth - 1));
            }
        }
        PortalTransform back = portals.transform(partner);
        List<Piece> here = new ArrayList<>();
        for (Piece piece : there) {
            List<ConvexPolyhedron> shapes = new ArrayList<>();
            if (reachesBefore(partner, piece.shape())) {
                opening.fill(back.polyhedron(piece.shape()), shapes);
            }
            shapes.forEach(shape -> here.add(piece.with(shape)));
        }
        return here;
    }

    private boolean reachesBefore(int portal, ConvexPolyhedron shape) {
        Portal plane = portals.portal(portal);
        return shape.vertices().stream().anyMatch(corner -> plane.inFront(corner.x(), corner.y(), corner.z()) > 0);
    }

    private static Aabb moved(Aabb box, PortalTransform transform) {
        List<Vec3> corners = ConvexPolyhedron.box(box).vertices();
        return Aabb.of(corners.stream().map(transform::point).toList());
    }

    /** Returns the open portals, other than the exit itself, that can be reached from in front of an exit. */
    private long reached(int exit, double reachMetres) {
        long mask = 0;
        for (int i = 0; i < Math.min(portals.size(), Long.SIZE); i++) {
            boolean open = i != exit && portals.isOpen(i);
            if (open && isBefore(exit, i) && distance(exit, i) < reachMetres - LEAST_REACH_METRES) {
                mask |= 1L << i;
            }
        }
        return mask;
    }

    private boolean isBefore(int exit, int other) {
        Portal plane = portals.portal(exit);
        return portals.portal(other).corners().stream()
                .anyMatch(corner -> plane.inFront(corner.x(), corner.y(), corner.z()) > 1e-6);
    }

    /** Returns a lower bound of the distance in metres between two apertures. */
    private double distance(int a, int b) {
        Aabb first = Aabb.of(portals.portal(a).corners());
        Aabb second = Aabb.of(portals.portal(b).corners());
        double x = apart(first.minX(), first.maxX(), second.minX(), second.maxX());
        double y = apart(first.minY(), first.maxY(), second.minY(), second.maxY());
        double z = apart(first.minZ(), first.maxZ(), second.minZ(), second.maxZ());
        return Math.sqrt(x * x + y * y + z * z);
    }

    private static double apart(double minA, double maxA, double minB, double maxB) {
        return Math.max(0, Math.max(minA - maxB, minB - maxA));
    }
}
