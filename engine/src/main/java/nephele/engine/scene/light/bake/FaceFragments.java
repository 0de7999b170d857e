package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import nephele.engine.level.Brush;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.FaceCut.Piece;

/**
 * Faces divided along the footprints of the solids on them. A wall on a floor separates the floor's light map into
 * inside and outside, so no interpolation leaks light under the wall. Immutable; after an edit only the vicinity of
 * changes is divided again, with the result of a full division, bit by bit.
 *
 * <p>A shape's fragments are computed in three steps: its faces are divided by the shapes near it, the pieces' corners
 * are welded to equal ones nearby, and the corners of the shapes near it are inserted into its pieces' edges. Each step
 * is repeated for the shapes that a change in the previous step can affect; welding has a reach of a micrometre, far
 * below that of {@link Neighbours}.
 */
public final class FaceFragments {
    /** Corners up to this distance from another one are welded to it. */
    public static final double WELD_METRES = 1e-6;

    private static final int NEW = IdentityDiff.NEW;

    /** An edit with more new brushes is divided from scratch. */
    private static final int MOST_NEW = 32;

    private final BiFunction<ConvexPolyhedron.Face, List<ConvexPolyhedron>, List<Piece>> divide;
    private final List<Brush> brushes;
    /** Distinct shapes: equal solids share their fragments, because a face never covers its own copy. */
    private final List<ConvexPolyhedron> shapes = new ArrayList<>();

    private final int[] numberOf;
    private final Neighbours neighbours;
    private final List<List<List<Piece>>> divided = new ArrayList<>();
    private final List<List<List<Piece>>> welded = new ArrayList<>();
    private final List<List<List<FaceFragment>>> joined = new ArrayList<>();
    private final List<List<List<FaceFragment>>> byBrush;

    private FaceFragments(
            BiFunction<ConvexPolyhedron.Face, List<ConvexPolyhedron>, List<Piece>> divide,
            List<Brush> brushes,
            FaceFragments known) {
        this.divide = divide;
        this.brushes = List.copyOf(brushes);
        this.numberOf = new int[brushes.size()];
        int[] places = known == null ? null : IdentityDiff.previousIndices(known.brushes, brushes);
        boolean isEdit = known != null
                && IntStream.of(places).filter(place -> place == NEW).count() <= MOST_NEW;
        int[] before = isEdit ? numbered(places, known) : numbered();
        boolean isKnown = isEdit && isAscending(before);
        List<Aabb> boxes = shapes.stream().map(ConvexPolyhedron::bounds).toList();
        if (isKnown) {
            neighbours = known.neighbours.edited(boxes, before);
        } else {
            Arrays.fill(before, NEW);
            neighbours = Neighbours.of(boxes, FaceCut.PROBE_METRES);
        }
        boolean[] hasOtherNeighbours = hasOtherNeighbours(before, known);
        boolean[] changed = divide(before, known, hasOtherNeighbours);
        changed = weld(before, known, reached(changed, hasOtherNeighbours));
        join(before, known, reached(changed, hasOtherNeighbours));
        byBrush = IntStream.of(numberOf).mapToObj(joined::get).toList();
    }

    /** Divides the faces of all brushes. */
    public static FaceFragments of(List<Brush> brushes) {
        return new FaceFragments(FaceCut::cut, brushes, null);
    }

    /**
     * Same as {@link #of}, but every face remains whole: the corners of its neighbours are inserted into its edges, or
     * it is hidden entirely.
     */
    public static FaceFragments uncut(List<Brush> brushes) {
        return new FaceFragments(FaceCut::whole, brushes, null);
    }

    /** Returns the fragments of other brushes; unchanged parts are the same objects. */
    public FaceFragments edited(List<Brush> brushes) {
        return brushes == this.brushes ? this : new FaceFragments(divide, brushes, this);
    }

    /** Returns the fragments by brush and by face of its shape; together they cover each face exactly. */
    public List<List<List<FaceFragment>>> byBrush() {
        return byBrush;
    }

    /** Numbers the shapes in the order of the brushes; all of them are new. */
    private int[] numbered() {
        Map<ConvexPolyhedron, Integer> numbers = new HashMap<>();
        for (int i = 0; i < numberOf.length; i++) {
            ConvexPolyhedron shape = brushes.get(i).shape();
            Integer number = numbers.putIfAbsent(shape, shapes.size());
            numberOf[i] = number == null ? shapes.size() : number;
            if (number == null) {
                shapes.add(shape);
            }
        }
        int[] before = new int[shapes.size()];
        Arrays.fill(before, NEW);
        return before;
    }

    /**
     * Numbers the shapes in the order of the brushes.
     *
     * @param places the indices of the brushes among those known
     * @return each shape's number among those known, {@link #NEW} if it is not known
     */
    private int[] numbered(int[] places, FaceFragments known) {
        int[] now = new int[known.shapes.size()];
        Arrays.fill(now, NEW);
        int[] before = new int[places.length];
        for (int i = 0; i < places.length; i++) {
            ConvexPolyhedron shape = brushes.get(i).shape();
            int old = places[i] == NEW ? known.shapes.indexOf(shape) : known.numberOf[places[i]];
            int number = old == NEW ? numberAmongNew(shape, before) : now[old];
            if (number == NEW) {
                number = shapes.size();
                shapes.add(shape);
                before[number] = old;
            }
            if (old != NEW) {
                now[old] = number;
            }
            numberOf[i] = number;
        }
        return Arrays.copyOf(before, shapes.size());
    }

    private int numberAmongNew(ConvexPolyhedron shape, int[] before) {
        for (int i = 0; i < shapes.size(); i++) {
            if (before[i] == NEW && shapes.get(i).equals(shape)) {
                return i;
            }
        }
        return NEW;
    }

    private static boolean isAscending(int[] before) {
        int last = NEW;
        for (int number : before) {
            if (number != NEW && number < last) {
                return false;
            }
            last = Math.max(last, number);
        }
        return true;
    }

    private boolean[] hasOtherNeighbours(int[] before, FaceFragments known) {
        boolean[] differs = new boolean[before.length];
        for (int shape = 0; shape < before.length; shape++) {
            int[] now = neighbours.of(shape);
            int[] then = before[shape] == NEW ? null : known.neighbours.of(before[shape]);
            differs[shape] = then == null || now.length != then.length;
            for (int i = 0; i < now.length && !differs[shape]; i++) {
                differs[shape] = before[now[i]] != then[i];
            }
        }
        return differs;
    }

    /** Returns for each shape true if it or one near it has changed. */
    private boolean[] reached(boolean[] changed, boolean[] also) {
        boolean[] reached = new boolean[changed.length];
        for (int shape = 0; shape < changed.length; shape++) {
            reached[shape] = changed[shape] || also[shape];
            for (int other : neighbours.of(shape)) {
                reached[shape] |= changed[other];
            }
        }
        return reached;
    }

    /** Fills {@link #divided}; returns for each shape true if it has changed. */
    private boolean[] divide(int[] before, FaceFragments known, boolean[] isDue) {
        boolean[] changed = new boolean[before.length];
        for (int shape = 0; shape < before.length; shape++) {
            List<List<Piece>> then = before[shape] == NEW ? null : known.divided.get(before[shape]);
            List<List<Piece>> now = then;
            if (isDue[shape]) {
                List<ConvexPolyhedron> near = Arrays.stream(neighbours.of(shape))
                        .mapToObj(shapes::get)
                        .toList();
                now = shapes.get(shape).faces().stream()
                        .map(face -> divide.apply(face, near))
                        .toList();
            }
            changed[shape] = now != then && !now.equals(then);
            divided.add(changed[shape] ? now : then);
        }
        return changed;
    }

    /** Fills {@link #welded}; returns for each shape true if it has changed. */
    private boolean[] weld(int[] before, FaceFragments known, boolean[] isDue) {
        CornerWeld weld = new CornerWeld();
        boolean[] isFollowed = reached(isDue, isDue);
        boolean[] changed = new boolean[before.length];
        for (int shape = 0; shape < before.length; shape++) {
            List<List<Piece>> then = before[shape] == NEW ? null : known.welded.get(before[shape]);
            List<List<Piece>> now = isFollowed[shape] ? welded(shape, weld) : then;
            changed[shape] = isDue[shape] && !now.equals(then);
            welded.add(changed[shape] ? now : then);
        }
        return changed;
    }

    private List<List<Piece>> welded(int shape, CornerWeld weld) {
        List<List<Piece>> pieces = divided.get(shape);
        return neighbours.of(shape).length == 0
                ? pieces
                : pieces.stream()
                        .map(face -> face.stream()
                                .map(piece -> new Piece(
                                        piece.cover(),
                                        piece.outline().stream()
                                                .map(weld::welded)
                                                .toList()))
                                .toList())
                        .toList();
    }

    private void join(int[] before, FaceFragments known, boolean[] isDue) {
        for (int shape = 0; shape < before.length; shape++) {
            List<List<FaceFragment>> then = before[shape] == NEW ? null : known.joined.get(before[shape]);
            List<List<FaceFragment>> now = isDue[shape] ? joined(shape) : then;
            joined.add(then != null && now != then && FaceFragment.areSame(now, then) ? then : now);
        }
    }

    private List<List<FaceFragment>> joined(int shape) {
        int[] near = neighbours.of(shape);
        if (near.length == 0) {
            return shapes.get(shape).faces().stream()
                    .map(face -> List.of(FaceFragment.whole(face.polygon())))
                    .toList();
        }
        CornerJoin join = new CornerJoin(shapes.get(shape), welded.get(shape));
        for (int other : near) {
            join.add(welded.get(other));
        }
        return join.joined(welded.get(shape));
    }

    /** Welds corners: all corners within a micrometre of the first one get its bits. */
    public static final class CornerWeld {

        private static final double CELL_METRES = 1e-3;
        /** Keeps whole millimetres, which are common in levels, away from the cells' borders. */
        private static final double OFFSET_METRES = 3.7e-4;

        /** The corners by {@link #key} of their cell; cells far apart may have the same key. */
        private final Map<Long, List<Vec3>> corners = new HashMap<>();

        Vec3 welded(Vec3 p) {
            for (long x = cell(p.x() - WELD_METRES); x <= cell(p.x() + WELD_METRES); x++) {
                for (long y = cell(p.y() - WELD_METRES); y <= cell(p.y() + WELD_METRES); y++) {
                    for (long z = cell(p.z() - WELD_METRES); z <= cell(p.z() + WELD_METRES); z++) {
                        Vec3 known = knownIn(key(x, y, z), p);
                        if (known != null) {
                            return known;
                        }
                    }
                }
            }
            corners.computeIfAbsent(key(cell(p.x()), cell(p.y()), cell(p.z())), key -> new ArrayList<>(1))
                    .add(p);
            return p;
        }

        private Vec3 knownIn(long key, Vec3 p) {
            for (Vec3 known : corners.getOrDefault(key, List.of())) {
                if (known.toVector().distance(p.x(), p.y(), p.z()) <= WELD_METRES) {
                    return known;
                }
            }
            return null;
        }

        private static long key(long x, long y, long z) {
            return (x & 0x1fffff) << 42 | (y & 0x1fffff) << 21 | z & 0x1fffff;
        }

        private static long cell(double metres) {
            return (long) Math.floor((metres + OFFSET_METRES) / CELL_METRES);
        }
    }

    /** Inserts the corners of neighbouring fragments, on any face, into a fragment's edges, with the same bits. */
    private static final class CornerJoin {
        private final ConvexPolyhedron shape;
        private final Aabb around;
        private final double reachMetres;
        private final Set<Vec3> corners = new LinkedHashSet<>();

        /**
         * Starts with the corners of one shape.
         *
         * @param pieces the shape's welded pieces, by face
         */
        CornerJoin(ConvexPolyhedron shape, List<List<Piece>> pieces) {
            this.shape = shape;
            Aabb box = shape.bounds();
            double longest = box.maxX() - box.minX() + box.maxY() - box.minY() + box.maxZ() - box.minZ();
            // A corner counts as between two others if its distance to their edge is at most a micrometre plus 0.71e-6
            // of
            // the edge's length.
            reachMetres = 10 * FaceFragments.WELD_METRES + 1e-6 * longest;
            around = box.grown(reachMetres);
            add(pieces);
        }

        /** Adds the corners of a shape nearby. */
        void add(List<List<Piece>> pieces) {
            for (List<Piece> face : pieces) {
                for (Piece piece : face) {
                    for (Vec3 p : piece.outline()) {
                        if (holds(p)) {
                            corners.add(p);
                        }
                    }
                }
            }
        }

        private boolean holds(Vec3 p) {
            return around.minX() <= p.x()
                    && p.x() <= around.maxX()
                    && around.minY() <= p.y()
                    && p.y() <= around.maxY()
                    && around.minZ() <= p.z()
                    && p.z() <= around.maxZ();
        }

        List<List<FaceFragment>> joined(List<List<Piece>> pieces) {
            List<List<FaceFragment>> byFace = new ArrayList<>();
            for (int face = 0; face < pieces.size(); face++) {
                List<Vec3> onPlane = onPlane(shape.faces().get(face).plane());
                byFace.add(pieces.get(face).stream()
                        .map(p -> FaceFragment.of(p.cover(), p.outline(), withNeighbours(p.outline(), onPlane)))
                        .toList());
            }
            return byFace;
        }

        private List<Vec3> onPlane(Plane plane) {
            List<Vec3> on = new ArrayList<>();
            for (Vec3 p : corners) {
                if (Math.abs(plane.signedDistance(p)) <= 2 * FaceFragments.WELD_METRES) {
                    on.add(p);
                }
            }
            return on;
        }

        private List<Vec3> withNeighbours(List<Vec3> outline, List<Vec3> corners) {
            List<Vec3> joined = new ArrayList<>();
            List<Vec3> between = new ArrayList<>();
            for (int i = 0; i < outline.size(); i++) {
                Vec3 a = outline.get(i);
                Vec3 b = outline.get((i + 1) % outline.size());
                joined.add(a);
                for (Vec3 p : corners) {
                    if (isNear(a, b, p) && !p.equals(a) && !p.equals(b) && liesBetween(a, b, p)) {
                        between.add(p);
                    }
                }
                between.sort((p, q) -> Double.compare(squareDistance(a, p), squareDistance(a, q)));
                joined.addAll(between);
                between.clear();
            }
            return joined;
        }

        /** Returns true if a point is in the bounding box of an edge. */
        private boolean isNear(Vec3 a, Vec3 b, Vec3 p) {
            return isWithin(a.x(), b.x(), p.x()) && isWithin(a.y(), b.y(), p.y()) && isWithin(a.z(), b.z(), p.z());
        }

        private boolean isWithin(double a, double b, double p) {
            return Math.min(a, b) - reachMetres <= p && p <= Math.max(a, b) + reachMetres;
        }

        private static boolean liesBetween(Vec3 a, Vec3 b, Vec3 p) {
            double whole = Math.sqrt(squareDistance(a, b));
            if (whole <= 2 * FaceFragments.WELD_METRES) {
                return false;
            }
            double parts = Math.sqrt(squareDistance(a, p)) + Math.sqrt(squareDistance(p, b));
            // A corner at the distance h from an edge of length L makes the path about 2h²/L longer.
            return parts - whole <= 2 * FaceFragments.WELD_METRES * FaceFragments.WELD_METRES / whole + 1e-12 * whole;
        }

        private static double squareDistance(Vec3 a, Vec3 b) {
            return a.toVector().distanceSquared(b.x(), b.y(), b.z());
        }
    }
}
