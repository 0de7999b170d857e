package nephele.engine.reference;

import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.Vec3;

/** The faces of solids that are mirrors, with their tints. Immutable. */
final class ReflectingFaces {
    static final ReflectingFaces NONE = new ReflectingFaces(new Face[0][]);

    private final Face[][] faces;

    /**
     * One mirror.
     *
     * @param normal unit length, outwards
     * @param tint factor on radiance, linear RGB
     */
    record Face(Vec3 normal, Vec3 tint) {}

    private ReflectingFaces(Face[][] faces) {
        this.faces = faces;
    }

    static ReflectingFaces of(List<Brush> brushes, MaterialTextures textures) {
        Face[][] faces = brushes.stream()
                .map(brush ->
                        brush.faces().stream().map(face -> face(face, textures)).toArray(Face[]::new))
                .toArray(Face[][]::new);
        return new ReflectingFaces(faces);
    }

    private static Face face(Brush.BrushFace face, MaterialTextures textures) {
        var material = textures.skin(face.material()).material();
        return material.mirror() ? new Face(face.plane().normal(), material.baseColour()) : null;
    }

    boolean mayBe(int item) {
        return item < faces.length;
    }

    /** Returns {@code null} for a face that is not a mirror. */
    Face at(int item, int face) {
        return faces[item][face];
    }
}
