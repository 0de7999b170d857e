package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Brush;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Material;
import nephele.engine.level.Solid;
import nephele.engine.level.Sun;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/** White boxes lit only by a sun or by punctual lights. */
final class WhiteBoxes {
    private final List<Solid> solids = new ArrayList<>();

    /** Adds a box by centre and size, in metres. */
    void box(double x, double y, double z, double sizeX, double sizeY, double sizeZ) {
        var centre = new Vec3(x, y, z);
        var size = new Vec3(sizeX, sizeY, sizeZ);
        String id = "box-" + solids.size();
        solids.add(new Solid.Box(id, "white", false, TextureMapping.WORLD, centre, size, Map.of()));
    }

    List<Brush> brushes() {
        return solids.stream().map(Brush::of).toList();
    }

    /** @param sun {@code null} for none */
    Level lit(Sun sun, List<Light> lights) {
        var environment = new Environment(sun, null, Vec3.ZERO, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        var white = new Material("white", new Vec3(1, 1, 1), null, null, null, null, Vec3.ZERO, 1);
        return Level.of("white boxes", "", environment, List.of())
                .with(List.of(white), List.copyOf(solids))
                .with(environment, lights);
    }
}
