package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** The blocks of an arch: half of an elliptic ring, cut by planes that neighbours share exactly. */
final class ArchShape {
    private static final int MOST_SEGMENTS = 256;

    private final Aabb box;
    private final boolean isAlongX;
    private final double halfWidth;
    private final double height;
    private final ShapeOptions.Arch options;

    private ArchShape(Aabb box, ShapeOptions.Arch options) {
        Vec3 size = ExactNumber.size(box);
        this.box = box;
        this.options = options;
        isAlongX = size.x() >= size.z();
        halfWidth = (isAlongX ? size.x() : size.z()) / 2;
        height = size.y();
    }

    static BrushEdit<List<Solid>> blocks(
            Aabb box, ShapeOptions.Arch options, BrushStyle style, Supplier<String> newIds) {
        ArchShape arch = new ArchShape(box, options);
        boolean isFitting = options.segments() >= 2
                && options.segments() <= MOST_SEGMENTS
                && options.thicknessMetres() >= BrushCheck.LEAST_THICKNESS_METRES
                && options.thicknessMetres()
                        <= Math.min(arch.halfWidth, arch.height) - BrushCheck.LEAST_THICKNESS_METRES;
        if (!isFitting) {
            return BrushEdit.refused(BrushText.BAD_OPTIONS);
        }
        List<Solid> blocks = new ArrayList<>();
        for (int i = 0; i < options.segments(); i++) {
            Solid.Planes planes = new Solid.Planes(
                    newIds.get(), style.material(), style.portalable(), style.textureMapping(), arch.block(i));
            BrushEdit<Solid> block = PlaneForm.rebuilt(planes);
            if (block.result().isEmpty()) {
                return BrushEdit.refused(block.refusal().orElseThrow());
            }
            blocks.add(block.result().get());
        }
        return BrushEdit.done(List.copyOf(blocks));
    }

    private List<PlaneFace> block(int i) {
        Vec3 inwards = isAlongX ? new Vec3(0, 0, 1) : new Vec3(1, 0, 0);
        double near = isAlongX ? box.minZ() : box.minX();
        double far = isAlongX ? box.maxZ() : box.maxX();
        Plane outer = through(outer(i), outer(i + 1));
        Plane inner = through(inner(i + 1), inner(i));
        List<PlaneFace> planes = new ArrayList<>();
        planes.add(PlaneForm.canonical(Plane.through(inwards, inwards.scaled(far))));
        planes.add(PlaneForm.canonical(Plane.through(inwards.negated(), inwards.scaled(near))));
        planes.add(PlaneForm.canonical(outer));
        planes.add(PlaneForm.canonical(inner));
        planes.add(PlaneForm.opposite(PlaneForm.canonical(joint(i))));
        planes.add(PlaneForm.canonical(joint(i + 1)));
        return planes;
    }

    /** Returns the plane between block {@code i} − 1 and block {@code i}, its normal towards the latter. */
    private Plane joint(int i) {
        if (i == 0 || i == options.segments()) {
            return Plane.through(new Vec3(0, i == 0 ? 1 : -1, 0), new Vec3(0, box.minY(), 0));
        }
        return through(inner(i), outer(i)).opposite();
    }

    private Vec3 outer(int i) {
        return onEllipse(i, halfWidth, height);
    }

    private Vec3 inner(int i) {
        return onEllipse(i, halfWidth - options.thicknessMetres(), height - options.thicknessMetres());
    }

    private Vec3 onEllipse(int i, double a, double b) {
        double angle = Math.PI * i / options.segments();
        double across = a * StrictMath.cos(angle);
        double up = i == 0 || i == options.segments() ? 0 : b * StrictMath.sin(angle);
        double middle = isAlongX ? (box.minX() + box.maxX()) / 2 : (box.minZ() + box.maxZ()) / 2;
        double along = ExactNumber.clean(middle + across, ExactNumber.OF_SUMS);
        double top = ExactNumber.clean(box.minY() + up, ExactNumber.OF_SUMS);
        return isAlongX ? new Vec3(along, top, 0) : new Vec3(0, top, along);
    }

    /** Returns the plane through two points of the section whose outside is to the right of the way from a to b. */
    private Plane through(Vec3 a, Vec3 b) {
        Vec3 way = b.minus(a);
        Vec3 right = isAlongX ? new Vec3(way.y(), -way.x(), 0) : new Vec3(0, -way.z(), way.y());
        return Plane.through(Plane.of(right, 0).normal(), a);
    }
}
