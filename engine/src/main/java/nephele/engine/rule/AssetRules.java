package nephele.engine.rule;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.level.Cloud;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.appearance.SkyboxPictures;
import nephele.engine.level.json.AssetPlaces;
import nephele.engine.level.placed.LevelRule;

/** Every file that the level names exists, and every picture and grid can be decoded. An instance has read a level's. */
final class AssetRules {
    static final LevelRule READABLE = new LevelRule(LevelRule.Stage.FILES, (level, assets, statics, report) -> {
        AssetRules rules = new AssetRules(assets, report);
        LevelRule.each("materials", level.materials(), (path, material) -> {
            rules.picture(path + ".texture", material.texture());
            rules.picture(path + ".normalTexture", material.normalTexture());
        });
        if (level.environment().sky() instanceof Sky.Skybox skybox) {
            rules.skybox("environment.sky.files", skybox);
        }
        LevelRule.each("billboards", level.billboards(), (path, group) -> {
            Verdict verdict = rules.picture(path + ".sprite", group.sprite());
            if (verdict != null) {
                BillboardRules.frames(path, group, verdict.width(), report);
            }
        });
        LevelRule.each(
                "environment.clouds",
                level.environment().clouds(),
                (path, cloud) -> rules.density(path + ".density", cloud));
        rules.memory(AssetPlaces.of(level));
    });

    private static final double MUCH_MEMORY_BYTES = 450e6;

    /** @param objection {@code null} for a usable picture, of the given size */
    private record Verdict(String objection, int width, int height) {}

    private final AssetSource assets;
    private final Consumer<Problem> report;
    private final Map<String, Verdict> verdicts = new TreeMap<>();

    private AssetRules(AssetSource assets, Consumer<Problem> report) {
        this.assets = assets;
        this.report = report;
    }

    /** Returns the picture's size, or reports a problem and returns {@code null}. */
    private Verdict picture(String path, String id) {
        Verdict verdict = id == null ? null : verdicts.computeIfAbsent(id, this::verdict);
        if (verdict != null && verdict.objection() != null) {
            report.accept(Problem.error(path, verdict.objection()).about(Topic.MISSING_ASSET));
            return null;
        }
        return verdict;
    }

    private Verdict verdict(String id) {
        try {
            Picture picture = PictureDecoder.decode(id, assets.bytes(id));
            return new Verdict(null, picture.width(), picture.height());
        } catch (AssetException problem) {
            return new Verdict(problem.getMessage(), 0, 0);
        }
    }

    private void skybox(String path, Sky.Skybox skybox) {
        Verdict first = null;
        for (int i = 0; i < skybox.files().size(); i++) {
            String file = skybox.files().get(i);
            Verdict size = picture(path + "[" + i + "]", file);
            first = first == null ? size : first;
            if (size != null) {
                size(path + "[" + i + "]", file, size, skybox.layout() == SkyboxLayout.CROSS ? null : first);
            }
        }
    }

    /** @param first the first of six faces, {@code null} for a cross */
    private void size(String path, String file, Verdict size, Verdict first) {
        try {
            if (first == null) {
                SkyboxPictures.crossSide(file, size.width(), size.height());
            } else {
                SkyboxPictures.requireFace(file, size.width(), size.height(), first.width());
            }
        } catch (AssetException problem) {
            report.accept(Problem.error(path, problem.getMessage()));
        }
    }

    /** Warns of pictures that together need much memory: four bytes a pixel, and as much again for one as it is read. */
    private void memory(Map<String, String> places) {
        double sum = 0;
        String largest = "";
        double most = 0;
        for (Map.Entry<String, Verdict> picture : verdicts.entrySet()) {
            double bytes = 4.0 * picture.getValue().width() * picture.getValue().height();
            sum += bytes;
            largest = bytes > most ? picture.getKey() : largest;
            most = Math.max(most, bytes);
        }
        if (sum + most > MUCH_MEMORY_BYTES) {
            report.accept(Problem.warning(
                    places.getOrDefault(largest, largest),
                    "the pictures of the level need some " + Math.round((sum + most) / 1e6) + " MB of memory, and '"
                            + largest + "' most of all: make them smaller"));
        }
    }

    private void density(String path, Cloud cloud) {
        Cloud.Density density = cloud.density();
        if (density instanceof Cloud.Density.Image image) {
            picture(path + ".file", image.file());
        } else if (density instanceof Cloud.Density.Grid grid) {
            grid(path + ".file", grid.file(), cloud.extent());
        } else if (density instanceof Cloud.Density.Noise noise) {
            picture(path + ".coverageMap", noise.coverageMap());
        }
    }

    private void grid(String path, String id, Cloud.Extent extent) {
        try {
            VoxelGrid grid = VoxelGrid.read(id, assets.bytes(id));
            if (extent instanceof Cloud.Extent.Layer) {
                VoxelGrid.requireArea(id, grid.box());
            }
        } catch (AssetException problem) {
            report.accept(Problem.error(path, problem.getMessage()).about(Topic.MISSING_ASSET));
        }
    }
}
