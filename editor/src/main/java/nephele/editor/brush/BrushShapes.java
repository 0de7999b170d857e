package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The solids that a drag from corner to corner draws. */
public final class BrushShapes {
    private static final int MOST_SIDES = 62;

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
            return ArchShape.blocks(box, arch, style, newIds);
        } else if (options instanceof ShapeOptions.Cylinder cylinder) {
            return shapes.cylinder(cylinder.sides());
        } else if (options instanceof ShapeOptions.Room room) {
            return BrushHollow.hollowed(shapes.box(box), room.wallMetres(), newIds);
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
        BoxFace longer = size.x() >= size.z() ? BoxFace.PLUS_X : BoxFace.PLUS_Z;
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

    /** Returns the part of the box between two shares of the way up. */
    private Aabb tread(BoxFace rising, double from, double to, double top) {
        return switch (rising) {
            case PLUS_X -> new Aabb(x(from), box.minY(), box.minZ(), x(to), top, box.maxZ());
            case MINUS_X -> new Aabb(x(1 - to), box.minY(), box.minZ(), x(1 - from), top, box.maxZ());
            case PLUS_Z -> new Aabb(box.minX(), box.minY(), z(from), box.maxX(), top, z(to));
            case MINUS_Z -> new Aabb(box.minX(), box.minY(), z(1 - to), box.maxX(), top, z(1 - from));
            case PLUS_Y, MINUS_Y -> throw new IllegalArgumentException("stairs rise towards a horizontal side");
        };
    }

    private double x(double share) {
        return ExactNumber.clean(box.minX() + size.x() * share, ExactNumber.OF_SUMS);
    }

    private double z(double share) {
        return ExactNumber.clean(box.minZ() + size.z() * share, ExactNumber.OF_SUMS);
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
}
