package nephele.editor.tool.extrude;

import java.util.List;
import java.util.Optional;
import nephele.editor.document.Selection.FaceRef;
import nephele.editor.pick.Pick;
import nephele.editor.pick.Picker;
import nephele.editor.record.EntityRef;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.PointerDrag;
import nephele.editor.tool.ScreenDistance;
import nephele.editor.tool.ToolContext;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.math.Vec3;

/**
 * The face that an extrusion begins at. In a plan it is a side of the nearest brush, since the face in front can move
 * only along the direction of sight.
 *
 * @param index in the order of {@code brush.faces()}
 * @param grabbed the place on the face at which the pointer takes it
 */
record FaceUnderPointer(Brush brush, int index, Vec3 grabbed) {
    private static final double EDGE_ON = 1e-3;

    static Optional<FaceUnderPointer> of(ToolContext context, Pointer pointer) {
        List<Pick> picks = context.picker().along(pointer.ray());
        Optional<Pick> solid = picks.stream()
                .filter(pick -> pick.entity().section().equals(Picker.SOLIDS))
                .findFirst();
        Optional<Brush> brush = solid.flatMap(pick -> context.shapes().brushes().stream()
                .filter(candidate -> candidate.solidId().equals(pick.entity().id()))
                .findFirst());
        if (brush.isEmpty()) {
            return Optional.empty();
        }
        return pointer.isPlan() ? side(brush.get(), pointer) : named(brush.get(), solid.get());
    }

    private static Optional<FaceUnderPointer> named(Brush brush, Pick pick) {
        for (int i = 0; i < brush.faces().size(); i++) {
            if (brush.faces().get(i).name().equals(pick.face())) {
                return Optional.of(new FaceUnderPointer(brush, i, pick.point()));
            }
        }
        return Optional.empty();
    }

    /** Returns the face nearest in the picture of those that are seen edge on. */
    private static Optional<FaceUnderPointer> side(Brush brush, Pointer pointer) {
        Vec3 forward = pointer.camera().forward();
        FaceUnderPointer nearest = null;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < brush.faces().size(); i++) {
            BrushFace face = brush.faces().get(i);
            double pixels = pixels(face, pointer);
            if (Math.abs(face.plane().normal().dot(forward)) < EDGE_ON && pixels < least) {
                least = pixels;
                nearest = new FaceUnderPointer(brush, i, face.polygon().get(0));
            }
        }
        return Optional.ofNullable(nearest);
    }

    private static double pixels(BrushFace face, Pointer pointer) {
        List<Vec3> ring = face.polygon();
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < ring.size(); i++) {
            Vec3 next = ring.get((i + 1) % ring.size());
            least = Math.min(least, ScreenDistance.toSegment(pointer, ring.get(i), next));
        }
        return least;
    }

    /** Returns the face's name in a selection. */
    FaceRef ref() {
        return new FaceRef(new EntityRef(Picker.SOLIDS, brush.solidId()), face().name());
    }

    BrushFace face() {
        return brush.faces().get(index);
    }

    /** Returns the distance along the normal, metres, between where two pointers point. */
    Optional<Double> between(Pointer from, Pointer to) {
        Vec3 normal = face().plane().normal();
        return PointerDrag.alongLine(from, grabbed, normal)
                .flatMap(begin -> PointerDrag.alongLine(to, grabbed, normal).map(end -> end - begin));
    }
}
