package nephele.engine.reference;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.Vec3;

/** Which faces of solids are mirrors, and how much light each reflects. Immutable. */
final class ReflectingFaces {
    static final ReflectingFaces NONE = new ReflectingFaces(new Face[0][]);

    private final Face[][] faces;

    /**
     * One mirror.
     *
     * @param normal unit length, outwards
     * @param tint what radiance is multiplied by
     */
    record Face(Vec3 normal, Vec3 tint) {}

    private ReflectingFaces(Face[][] faces) {
        this.faces = faces;
    }

    static ReflectingFaces of(List<Brush> brushes, Skins skins) {
        Face[][] faces = brushes.stream()
                .map(brush ->
                        brush.faces().stream().map(face -> face(face, skins)).toArray(Face[]::new))
                .toArray(Face[][]::new);
        return new ReflectingFaces(faces);
    }

    private static Face face(Brush.BrushFace face, Skins skins) {
        var material = skins.skin(face.material()).material();
        return material.mirror() ? new Face(face.plane().normal(), material.baseColour()) : null;
    }

    boolean mayBe(int item) {
        return item < faces.length;
    }

    /** {@code null} for a face that is no mirror. */
    Face at(int item, int face) {
        return faces[item][face];
    }
}
