package nephele.mutants;

import static nephele.mutants.Mutant.Area.MODEL;
import static nephele.mutants.Mutants.ENGINE;

import java.util.List;

/** Faults in shapes, curves and the readers of meshes. */
final class ModelMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    MODEL,
                    "the sides of a cone look up by the angle they should look out by",
                    ENGINE + "model/shape/ConeShape.java",
                    "height / length * sine, radius / length, height / length * cosine",
                    "radius / length * sine, height / length, radius / length * cosine",
                    "ShapeNormalsTest"),
            new Mutant(
                    MODEL,
                    "missing normals weigh each triangle alike",
                    ENGINE + "model/file/MissingNormals.java",
                    "normal.mul(StrictMath.atan2(length, a.dot(b)) / length);",
                    "normal.mul(1 / length);",
                    "MissingNormalsTest"),
            new Mutant(
                    MODEL,
                    "an index from the end names the point after",
                    ENGINE + "model/file/ObjFile.java",
                    "index < 0 ? count + index : index - 1",
                    "index < 0 ? count + index - 1 : index - 1",
                    "ObjFileTest"),
            new Mutant(
                    MODEL,
                    "every second triangle of a strip is inside out",
                    ENGINE + "model/file/GltfScene.java",
                    "mirrored != odd",
                    "mirrored",
                    "GltfFileTest"),
            new Mutant(
                    MODEL,
                    "a curve leaves its points too fast",
                    ENGINE + "model/CatmullRom.java",
                    "(1 + 2 * t) * u * u",
                    "(1 + t) * u * u",
                    "CatmullRomTest"),
            new Mutant(
                    MODEL,
                    "a patch rises where it falls",
                    ENGINE + "model/shape/BezierShape.java",
                    "6 * t * rest - 3 * t * t",
                    "6 * t * rest + 3 * t * t",
                    "BezierPatchesTest"));

    private ModelMutants() {}
}
