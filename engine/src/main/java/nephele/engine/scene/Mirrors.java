package nephele.engine.scene;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.scene.SceneMaterials.Surface;
import nephele.engine.scene.light.bake.FaceFragment;
import nephele.engine.scene.light.bake.FaceFragments;

/** Makes the openings for a level's mirror faces: one for each face that other solids do not hide entirely. */
final class Mirrors {
    private Mirrors() {}

    /**
     * Returns the mirrors of a level in the order of its faces.
     *
     * @param cut the faces of the level's solids, cut by each other
     */
    static List<Opening> of(Level level, StaticShapes statics, SceneMaterials materials, FaceFragments cut) {
        if (!MirrorFaces.any(level)) {
            return List.of();
        }
        List<Brush> brushes = statics.solids();
        List<List<List<FaceFragment>>> fragments = cut.byBrush();
        List<Opening> mirrors = new ArrayList<>();
        for (int brush = 0; brush < brushes.size(); brush++) {
            for (int face = 0; face < brushes.get(brush).faces().size(); face++) {
                BrushFace said = brushes.get(brush).faces().get(face);
                Surface surface = materials.surfaces().get(materials.indexOf(said.material()));
                List<Vec3> polygon = surface.material().mirror()
                        ? visible(said, fragments.get(brush).get(face))
                        : List.of();
                if (!polygon.isEmpty()) {
                    Vec3 tint = surface.material().baseColour();
                    mirrors.add(Opening.ofMirror(
                            mirrors.size(), polygon, said.plane().normal(), tint));
                }
            }
        }
        return List.copyOf(mirrors);
    }

    /**
     * Returns the uncovered part of a face if it is a single convex fragment, the whole face if there are several (the
     * solids in front hide the rest), and nothing if the face is covered entirely.
     */
    private static List<Vec3> visible(BrushFace face, List<FaceFragment> fragments) {
        List<FaceFragment> seen =
                fragments.stream().filter(part -> !part.isCovered()).toList();
        if (seen.isEmpty()) {
            return List.of();
        }
        return seen.size() == 1 ? seen.get(0).outline() : face.polygon();
    }
}
