package nephele.mutants;

import static nephele.mutants.Mutant.Area.PLANT;
import static nephele.mutants.Mutant.Area.TERRAIN;
import static nephele.mutants.Mutants.ENGINE;

import java.util.List;

/** Faults in terrains, billboards and impostors. */
final class GroundMutants {
    static final List<Mutant> ALL = List.of(
            new Mutant(
                    PLANT,
                    "billboards turn their backs to the eye",
                    ENGINE + "level/billboard/FacingAxes.java",
                    "new Vec3(toEye.z() / length, 0, -toEye.x() / length)",
                    "new Vec3(-toEye.z() / length, 0, toEye.x() / length)",
                    "FacingAxesTest"),
            new Mutant(
                    PLANT,
                    "an eye straight above a billboard has no axis",
                    ENGINE + "level/billboard/FacingAxes.java",
                    "return side > 1e-6 ?",
                    "return side > 2 ?",
                    "FacingAxesTest"),
            new Mutant(
                    PLANT,
                    "a field's plants stand closer than their spacing",
                    ENGINE + "level/billboard/PoissonDisc.java",
                    "!isInside || !isFree(x, z) ||",
                    "!isInside ||",
                    "PoissonDiscTest"),
            new Mutant(
                    PLANT,
                    "a field's plants stand on slopes that are too steep",
                    ENGINE + "level/billboard/FieldPlanting.java",
                    "place.normal().y() >= leastUp - 1e-12 && ",
                    "",
                    "FieldPlantingTest"),
            new Mutant(
                    PLANT,
                    "the density map of a field is mirrored",
                    ENGINE + "level/billboard/FieldPlanting.java",
                    "(x - area.minX()) / width",
                    "(area.maxX() - x) / width",
                    "FieldPlantingTest"),
            new Mutant(
                    TERRAIN,
                    "a height between samples is that of the other triangle",
                    ENGINE + "math/heightfield/HeightFieldSurface.java",
                    "if (v >= u) {",
                    "if (v < u) {",
                    "HeightFieldSurfaceTest"),
            new Mutant(
                    TERRAIN,
                    "the slope at a terrain's border counts cells that do not exist",
                    ENGINE + "math/heightfield/HeightFieldSurface.java",
                    "int after = Math.min(row + 1, field.cellRows());",
                    "int after = Math.min(row + 1, field.cellRows() - 1);",
                    "HeightFieldSurfaceTest"),
            new Mutant(
                    TERRAIN,
                    "a part of a terrain is farther than its nearest place",
                    ENGINE + "math/heightfield/DetailView.java",
                    "return middle - spread(along, box) / 2;",
                    "return middle + spread(along, box) / 2;",
                    "DetailViewTest"),
            new Mutant(
                    TERRAIN,
                    "a layer of a terrain begins half of its blend too late",
                    ENGINE + "level/terrain/TerrainLayers.java",
                    "limits[at] = layer.fromMetres() - half;",
                    "limits[at] = layer.fromMetres();",
                    "TerrainLayersTest"),
            new Mutant(
                    TERRAIN,
                    "layers are not mixed in shares of one",
                    ENGINE + "level/terrain/TerrainLayers.java",
                    "sum > 0 ? weights[i] / sum : i == 0 ? 1 : 0;",
                    "sum > 0 ? weights[i] : i == 0 ? 1 : 0;",
                    "TerrainLayersTest"),
            new Mutant(
                    TERRAIN,
                    "paint on a terrain is not taken from what is below",
                    ENGINE + "level/terrain/LayerPaint.java",
                    "weights[i] *= kept;",
                    "weights[i] *= 1;",
                    "LayerPaintTest"),
            new Mutant(
                    PLANT,
                    "views of an impostor are mirrored",
                    ENGINE + "scene/impostor/AtlasView.java",
                    "return (direction.x() - direction.z()) / sum(direction);",
                    "return (direction.z() - direction.x()) / sum(direction);",
                    "HemiOctahedronTest"),
            new Mutant(
                    PLANT,
                    "a planted model is turned the other way than its mesh",
                    ENGINE + "level/billboard/PlantedModels.java",
                    "StrictMath.atan2(-frame.m02(), frame.m00())",
                    "StrictMath.atan2(frame.m02(), frame.m00())",
                    "PlantedModelsTest"));

    private GroundMutants() {}
}
