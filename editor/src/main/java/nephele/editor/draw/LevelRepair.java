package nephele.editor.draw;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Brush;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
import nephele.engine.level.Terrain;
import nephele.engine.math.IdentityDiff;
import nephele.engine.math.Vec3;

/** Leaves out what cannot be drawn: broken solids, and files that are missing or unusable. */
public final class LevelRepair {
    private static final Sky INSTEAD_OF_SKYBOX =
            new Sky.Gradient(new Vec3(0.3, 0.4, 0.6), new Vec3(0.5, 0.5, 0.5), new Vec3(0.2, 0.2, 0.2));

    /** Messages by file. */
    private final Map<String, String> unusableFiles = new LinkedHashMap<>();
    /** Messages by solid. */
    private final Map<Solid, String> broken = new IdentityHashMap<>();

    private final DerivedRecords<Material, Material> materials = new DerivedRecords<>(this::usable);
    private List<ModelPlacement> refusedModels;
    private String modelsMessage;

    /** Returns what of a level is not shown, a line each. */
    public List<String> messages(Level level) {
        List<String> messages = new ArrayList<>();
        unusableFiles.forEach((file, message) -> {
            if (isNamed(level, file)) {
                messages.add(message);
            }
        });
        level.solids().stream().filter(broken::containsKey).map(broken::get).forEach(messages::add);
        if (level.models() == refusedModels) {
            messages.add(modelsMessage);
        }
        return messages;
    }

    public Level of(Level level) {
        if (unusableFiles.isEmpty() && broken.isEmpty() && refusedModels == null) {
            return level;
        }
        List<Solid> solids = level.solids().stream()
                .filter(solid -> !broken.containsKey(solid))
                .toList();
        Level repaired = level.with(
                unusableFiles.isEmpty() ? level.materials() : materials.of(level.materials()),
                IdentityDiff.list(level.solids(), solids),
                level.bodies(),
                models(level.models()));
        List<Terrain> terrains = level.terrains().stream()
                .filter(terrain -> !isUnusable(terrain.heightMap()))
                .map(terrain -> isPaintUnusable(terrain) ? terrain.withLayerMap(null) : terrain)
                .toList();
        repaired = terrains.equals(level.terrains()) ? repaired : repaired.withTerrains(terrains);
        Environment environment = usable(level.environment());
        return environment == level.environment() ? repaired : repaired.with(environment, level.lights());
    }

    private Environment usable(Environment authored) {
        boolean isSkyFine = !(authored.sky() instanceof Sky.Skybox skybox)
                || skybox.files().stream().noneMatch(this::isUnusable);
        List<Cloud> clouds = authored.clouds().stream()
                .filter(cloud ->
                        cloud.density().assetId().filter(this::isUnusable).isEmpty())
                .toList();
        Environment repaired = isSkyFine ? authored : authored.with(INSTEAD_OF_SKYBOX);
        return clouds.size() == authored.clouds().size() ? repaired : repaired.withClouds(clouds);
    }

    private boolean isUnusable(String file) {
        // The message of a mesh file names its line, too.
        return unusableFiles.keySet().stream().anyMatch(bad -> bad.equals(file) || bad.startsWith(file + ":"));
    }

    private boolean isPaintUnusable(Terrain terrain) {
        return terrain.layerMap() != null && isUnusable(terrain.layerMap());
    }

    private Material usable(Material authored) {
        boolean isColourFine = authored.texture() == null || !isUnusable(authored.texture());
        boolean areNormalsFine = authored.normalTexture() == null || !isUnusable(authored.normalTexture());
        return isColourFine && areNormalsFine
                ? authored
                : new Material(
                        authored.id(),
                        authored.baseColour(),
                        isColourFine ? authored.texture() : null,
                        authored.roughness(),
                        authored.metallic(),
                        areNormalsFine ? authored.normalTexture() : null,
                        authored.emission(),
                        authored.textureMetres(),
                        authored.mirror());
    }

    private List<ModelPlacement> models(List<ModelPlacement> all) {
        if (all == refusedModels) {
            return List.of();
        }
        Set<String> missing = new HashSet<>();
        all.stream().filter(model -> isUnusable(model.file())).forEach(model -> missing.add(model.id()));
        int known = -1;
        while (missing.size() > known) {
            known = missing.size();
            all.stream()
                    .filter(model -> model.parent() != null && missing.contains(model.parent()))
                    .forEach(model -> missing.add(model.id()));
        }
        return missing.isEmpty()
                ? all
                : all.stream().filter(model -> !missing.contains(model.id())).toList();
    }

    /**
     * Learns from a failure to derive or load a level of this derivation.
     *
     * @return true if the level is now another one, so that a new try may succeed
     */
    public boolean learn(Level level, RuntimeException failure) {
        if (failure instanceof AssetException file) {
            return learn(level, file);
        }
        return failure instanceof IllegalArgumentException && (learnSolids(level) || learnModels(level, failure));
    }

    private boolean learn(Level level, AssetException file) {
        boolean isNew = unusableFiles.put(file.assetId(), file.getMessage()) == null;
        // A list that is derived again drops the file from records that are the same.
        materials.of(List.of());
        return isNew && isNamed(level, file.assetId()) || learnModels(level, file);
    }

    private boolean isNamed(Level level, String assetId) {
        boolean isMaterials = level.materials().stream()
                .anyMatch(material -> assetId.equals(material.texture()) || assetId.equals(material.normalTexture()));
        boolean isModels = level.models().stream().anyMatch(model -> isUnusable(model.file()));
        boolean isSky = level.environment().sky() instanceof Sky.Skybox skybox
                && skybox.files().contains(assetId);
        boolean isClouds = level.environment().clouds().stream()
                .anyMatch(cloud ->
                        cloud.density().assetId().filter(assetId::equals).isPresent());
        boolean isTerrains = level.terrains().stream()
                .anyMatch(terrain -> isUnusable(terrain.heightMap()) || isPaintUnusable(terrain));
        return isMaterials || isModels || isTerrains || isSky || isClouds;
    }

    private boolean learnSolids(Level level) {
        Map<Solid, String> found = new IdentityHashMap<>();
        for (Solid solid : level.solids()) {
            String known = broken.get(solid);
            String message = known == null ? objection(solid) : known;
            if (message != null) {
                found.put(solid, message);
            }
        }
        boolean isNew = !broken.keySet().containsAll(found.keySet());
        broken.clear();
        broken.putAll(found);
        return isNew;
    }

    private static String objection(Solid solid) {
        try {
            Brush.of(solid);
            return null;
        } catch (IllegalArgumentException reason) {
            return "solids/" + solid.id() + ": " + reason.getMessage();
        }
    }

    private boolean learnModels(Level level, RuntimeException failure) {
        if (level.models().isEmpty() || level.models() == refusedModels) {
            return false;
        }
        refusedModels = level.models();
        modelsMessage = "models are not shown: " + failure.getMessage();
        return true;
    }
}
