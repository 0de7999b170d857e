package nephele.engine.level;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.PictureDecoder;

/** Every file that the level names is there, and every picture can be decoded. */
final class AssetRules {
    static final LevelRule READABLE = (level, assets, report) -> {
        Check check = new Check(assets, report, new HashMap<>());
        for (int i = 0; i < level.materials().size(); i++) {
            Material material = level.materials().get(i);
            check.picture("materials[" + i + "].texture", material.texture());
            check.picture("materials[" + i + "].normalTexture", material.normalTexture());
        }
        if (level.environment().sky() instanceof Sky.Skybox skybox) {
            check.pictures("environment.sky.files", skybox.files());
        }
        List<Cloud> clouds = level.environment().clouds();
        for (int i = 0; i < clouds.size(); i++) {
            check.density(
                    "environment.clouds[" + i + "].density.file", clouds.get(i).density());
        }
    };

    private AssetRules() {}

    private record Check(AssetSource assets, Consumer<Problem> report, Map<String, Optional<String>> verdicts) {
        void picture(String path, String id) {
            if (id != null) {
                verdicts.computeIfAbsent(id, this::objection)
                        .ifPresent(objection -> report.accept(Problem.error(path, objection)));
            }
        }

        private Optional<String> objection(String id) {
            try {
                PictureDecoder.decode(id, assets.bytes(id));
                return Optional.empty();
            } catch (AssetException problem) {
                return Optional.of(problem.getMessage());
            }
        }

        void pictures(String path, List<String> ids) {
            for (int i = 0; i < ids.size(); i++) {
                picture(path + "[" + i + "]", ids.get(i));
            }
        }

        void density(String path, Cloud.Density density) {
            if (density instanceof Cloud.Density.Image image) {
                picture(path, image.file());
            } else if (density instanceof Cloud.Density.Grid grid) {
                file(path, grid.file());
            }
        }

        void file(String path, String id) {
            if (!assets.exists(id)) {
                report.accept(Problem.error(
                        path, id + ": there is no such file; put it into the level's folder or into assets/"));
            }
        }
    }
}
