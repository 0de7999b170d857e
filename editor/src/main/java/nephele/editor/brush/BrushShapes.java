package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Makes the solids that a drag from corner to corner draws: box, wedge, stairs, arch, cylinder or room. */
public final class BrushShapes {
    private static final int MOST_SIDES = 62;
    private static final int MOST_ARCH_SEGMENTS = 256;

    private final Aabb box;
    private final Vec3 size;
    private final BrushStyle style;
    private final Supplier<String> newIds;

    private BrushShapes(Aabb box, BrushStyle style, Supplier<String> newIds) {
        this.box = box;
        this.size = ExactNumber.size(box);
        this.style = style;
        this.newIds = newIds;
    }

    /** Returns the solids of a shape inside a box. Ids are taken in the order of the solids. */
    public static BrushEdit<List<Solid>> drawn(
            Aabb box, ShapeOptions options, BrushStyle style, Supplier<String> newIds) {
        BrushShapes shapes = new BrushShapes(box, style, newIds);
        double thinnest = Math.min(shapes.size.x(), Math.min(shapes.size.y(), shapes.size.z()));
        if (!(thinnest >= BrushCheck.LEAST_THICKNESS_METRES)) {
            return BrushEdit.refused(BrushText.TOO_THIN);
        } else if (options instanceof ShapeOptions.Wedge wedge) {
            return shapes.wedge(shapes.rising(wedge.rising()));
        } else if (options instanceof ShapeOptions.Stairs stairs) {
            return shapes.stairs(shapes.rising(stairs.rising()), stairs.steps());
        } else if (options instanceof ShapeOptions.Arch arch) {
            return shapes.arch(arch);
        } else if (options instanceof ShapeOptions.Cylinder cylinder) {
            return shapes.cylinder(cylinder.sides());
        } else if (options instanceof ShapeOptions.Room room) {
            return BrushBoolean.hollowed(shapes.box(box), room.wallMetres(), newIds);
        }
        return all(List.of(shapes.box(box)));
    }

    private static BrushEdit<List<Solid>> all(List<Solid> solids) {
        for (Solid solid : solids) {
            var refusal = BrushCheck.refusal(solid);
            if (refusal.isPresent()) {
                return BrushEdit.refused(refusal.get());
            }
        }
        return BrushEdit.done(List.copyOf(solids));
    }

    private Solid box(Aabb bounds) {
        return new Solid.Box(
                newIds.get(),
                style.material(),
                style.portalable(),
                style.textureMapping(),
                ExactNumber.centre(bounds),
                ExactNumber.size(bounds),
                Map.of());
    }

    private BoxFace rising(BoxFace given) {
        BoxFace longer = isAlongX() ? BoxFace.PLUS_X : BoxFace.PLUS_Z;
        return given == null || given.normal().y() != 0 ? longer : given;
    }

    private BrushEdit<List<Solid>> wedge(BoxFace rising) {
        return all(List.of(new Solid.Wedge(
                newIds.get(),
                style.material(),
                style.portalable(),
                style.textureMapping(),
                ExactNumber.centre(box),
                size,
                rising,
                Map.of())));
    }

    private BrushEdit<List<Solid>> stairs(BoxFace rising, int steps) {
        if (steps < 1 || steps > ShapeOptions.MOST_STEPS) {
            return BrushEdit.refused(BrushText.BAD_OPTIONS);
        }
        List<Solid> treads = new ArrayList<>();
        for (int i = 0; i < steps; i++) {
            double top = box.minY() + size.y() * (i + 1) / steps;
            double from = i / (double) steps;
            double to = (i + 1) / (double) steps;
            treads.add(box(tread(rising, from, to, top)));
        }
        return all(treads);
    }

    /** Returns the part of the box between two fractions of the length of the stairs. */
    private Aabb tread(BoxFace rising, double from, double to, double top) {
        boolean isPlus = rising == BoxFace.PLUS_X || rising == BoxFace.PLUS_Z;
        double low = isPlus ? from : 1 - to;
        double high = isPlus ? to : 1 - from;
        return rising.normal().x() != 0
                ? new Aabb(x(low), box.minY(), box.minZ(), x(high), top, box.maxZ())
                : new Aabb(box.minX(), box.minY(), z(low), box.maxX(), top, z(high));
    }

    private double x(double fraction) {
        return ExactNumber.clean(box.minX() + size.x() * fraction, ExactNumber.OF_SUMS);
    }

    private double z(double fraction) {
        return ExactNumber.clean(box.minZ() + size.z() * fraction, ExactNumber.OF_SUMS);
    }

    /** Returns the blocks of an arch: half of an elliptic ring, cut by planes that neighbours share exactly. */
    private BrushEdit<List<Solid>> arch(ShapeOptions.Arch options) {
        double thickness = options.thicknessMetres();
        boolean isFitting = options.segments() >= 2
                && options.segments() <= MOST_ARCH_SEGMENTS
                && thickness >= BrushCheck.LEAST_THICKNESS_METRES
                && thickness <= Math.min(halfWidth(), size.y()) - BrushCheck.LEAST_THICKNESS_METRES;
        if (!isFitting) {
            return BrushEdit.refused(BrushText.BAD_OPTIONS);
        }
        List<Solid> blocks = new ArrayList<>();
        for (int i = 0; i < options.segments(); i++) {
            Solid.Planes planes = new Solid.Planes(
                    newIds.get(), style.material(), style.portalable(), style.textureMapping(), block(options, i));
            BrushEdit<Solid> block = PlaneForm.rebuilt(planes);
            if (block.result().isEmpty()) {
                return BrushEdit.refused(block.refusal().orElseThrow());
            }
            blocks.add(block.result().get());
        }
        return BrushEdit.done(List.copyOf(blocks));
    }

    private List<PlaneFace> block(ShapeOptions.Arch options, int i) {
        Vec3 inwards = isAlongX() ? new Vec3(0, 0, 1) : new Vec3(1, 0, 0);
        double near = isAlongX() ? box.minZ() : box.minX();
        double far = isAlongX() ? box.maxZ() : box.maxX();
        Plane outer = through(outer(options, i), outer(options, i + 1));
        Plane inner = through(inner(options, i + 1), inner(options, i));
        List<PlaneFace> planes = new ArrayList<>();
        planes.add(PlaneForm.canonical(Plane.through(inwards, inwards.scaled(far))));
        planes.add(PlaneForm.canonical(Plane.through(inwards.negated(), inwards.scaled(near))));
        planes.add(PlaneForm.canonical(outer));
        planes.add(PlaneForm.canonical(inner));
        planes.add(PlaneForm.opposite(PlaneForm.canonical(joint(options, i))));
        planes.add(PlaneForm.canonical(joint(options, i + 1)));
        return planes;
    }

    /** Returns the plane between block {@code i} − 1 and block {@code i}, its normal towards the latter. */
    private Plane joint(ShapeOptions.Arch options, int i) {
        if (i == 0 || i == options.segments()) {
            return Plane.through(new Vec3(0, i == 0 ? 1 : -1, 0), new Vec3(0, box.minY(), 0));
        }
        return through(inner(options, i), outer(options, i)).opposite();
    }

    private Vec3 outer(ShapeOptions.Arch options, int i) {
        return onEllipse(options, i, 0);
    }

    private Vec3 inner(ShapeOptions.Arch options, int i) {
        return onEllipse(options, i, options.thicknessMetres());
    }

    private Vec3 onEllipse(ShapeOptions.Arch options, int i, double insetMetres) {
        double a = halfWidth() - insetMetres;
        double b = size.y() - insetMetres;
        double angle = Math.PI * i / options.segments();
        double across = a * StrictMath.cos(angle);
        double up = i == 0 || i == options.segments() ? 0 : b * StrictMath.sin(angle);
        double middle = isAlongX() ? (box.minX() + box.maxX()) / 2 : (box.minZ() + box.maxZ()) / 2;
        double along = ExactNumber.clean(middle + across, ExactNumber.OF_SUMS);
        double top = ExactNumber.clean(box.minY() + up, ExactNumber.OF_SUMS);
        return isAlongX() ? new Vec3(along, top, 0) : new Vec3(0, top, along);
    }

    /** Returns the plane through two points of the section whose outside is to the right of the path from a to b. */
    private Plane through(Vec3 a, Vec3 b) {
        Vec3 along = b.minus(a);
        Vec3 right = isAlongX() ? new Vec3(along.y(), -along.x(), 0) : new Vec3(0, -along.z(), along.y());
        return Plane.through(Plane.of(right, 0).normal(), a);
    }

    private boolean isAlongX() {
        return size.x() >= size.z();
    }

    private double halfWidth() {
        return Math.max(size.x(), size.z()) / 2;
    }

    /** A square base is filled by a regular prism; another one by a regular prism that is stretched along x and z. */
    private BrushEdit<List<Solid>> cylinder(int sides) {
        if (sides < 3 || sides > MOST_SIDES) {
            return BrushEdit.refused(BrushText.BAD_OPTIONS);
        }
        Solid.Prism unit = prism(1, sides);
        Aabb reach = Brush.of(unit).shape().bounds();
        double radiusX = size.x() / 2 / Math.max(reach.maxX(), -reach.minX());
        double radiusZ = size.z() / 2 / Math.max(reach.maxZ(), -reach.minZ());
        Vec3 centre = ExactNumber.centre(box);
        if (size.x() == size.z()) {
            Solid.Prism round = prism(Math.min(radiusX, radiusZ), sides);
            return all(List.of(SolidTransform.moved(round, centre)));
        }
        return SolidTransform.scaled(unit, Vec3.ZERO, new Vec3(radiusX, 1, radiusZ))
                .flatMap(stretched -> all(List.of(SolidTransform.moved(stretched, centre))));
    }

    private Solid.Prism prism(double radius, int sides) {
        return new Solid.Prism(
                newIds.get(),
                style.material(),
                style.portalable(),
                style.textureMapping(),
                Vec3.ZERO,
                radius,
                size.y(),
                sides,
                Map.of());
    }

    /**
     * Returns the slabs of a room with telling ids.
     *
     * @param freshIds returns an unused id for the word of a side: floor, ceiling, north, south, east, west
     */
    public static List<Solid> named(List<Solid> slabs, Aabb room, UnaryOperator<String> freshIds) {
        List<Solid> named = new ArrayList<>();
        for (Solid slab : slabs) {
            named.add(slab.withId(freshIds.apply(side(slab, room.centre()))));
        }
        return List.copyOf(named);
    }

    private static String side(Solid slab, Vec3 centre) {
        Aabb box = Brush.of(slab).shape().bounds();
        if (box.maxY() < centre.y()) {
            return "floor";
        } else if (box.minY() > centre.y()) {
            return "ceiling";
        } else if (box.maxZ() < centre.z()) {
            return "north";
        } else if (box.minZ() > centre.z()) {
            return "south";
        }
        return box.minX() > centre.x() ? "east" : "west";
    }
}
