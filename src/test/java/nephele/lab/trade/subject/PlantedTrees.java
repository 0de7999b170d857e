package nephele.lab.trade.subject;

import java.util.List;
import java.util.Optional;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Billboards;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.ModelPlacement.TransformStep;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import nephele.host.named.OpenedLevel;

/** A few trees on level ground, single ones and a field. */
final class PlantedTrees {
    private static final String OAK = "models/plants/oak.3d";
    private static final String LEAVES = "textures/plants.png";

    private PlantedTrees() {}

    static OpenedLevel opened() {
        TransformStep sunk = new TransformStep.Translate(new Vec3(0, -0.15, 0));
        Billboards.Field field = new Billboards.Field(null, 3, 9, 8, null, 90, null);
        var level = new TestLevel()
                .sky(new Sky.Gradient(new Vec3(0.2, 0.4, 0.9), new Vec3(0.6, 0.6, 0.6), new Vec3(0.2, 0.15, 0.1)))
                .sun(new Vec3(0.5, 0.8, 0.4), 3)
                .ambient(0.4)
                .textured("plants", LEAVES)
                .material("ground", new Vec3(0.4, 0.3, 0.2))
                .box("ground", new Vec3(0, -0.5, 0), new Vec3(60, 1, 60))
                .impostor(
                        OAK,
                        "plants",
                        new TransformStep.Translate(new Vec3(-3, 0, 36)),
                        new TransformStep.Rotate(new Vec3(0, 1, 0), 50),
                        new TransformStep.Scale(new Vec3(1.2, 1.2, 1.2)))
                .planted(new ModelPlacement("field", OAK, null, List.of(sunk), "plants", false).over(field, 0.4))
                .level();
        TestAssets assets = new TestAssets().committed(OAK).committed(LEAVES);
        return new OpenedLevel(new LevelFile.Opened("trees", level, assets, Optional.empty()));
    }
}
