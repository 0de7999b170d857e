package nephele.engine.scene;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.level.Material;
import nephele.engine.math.IdentityDiff;

/**
 * The level's materials by index; their pictures are merged into one array for each size.
 *
 * @param surfaces index 0 is the default grey of faces without a material
 * @param colourArrays pictures in sRGB
 * @param normalArrays normal maps: linear, alpha multiplies roughness
 */
public record SceneMaterials(
        List<Surface> surfaces,
        List<PictureArray> colourArrays,
        List<PictureArray> normalArrays,
        Map<String, Integer> indexById) {
    static final SceneMaterials NONE = new SceneMaterials(List.of(), List.of(), List.of(), Map.of());

    /** Pictures of equal size, 8-bit RGBA. */
    public record PictureArray(int width, int height, List<Picture> layers) {}

    /** The location of a picture: array index and layer. */
    public record Slot(int array, int layer) {
        public static final Slot NONE = new Slot(-1, 0);
    }

    /** A material with the locations of its pictures. */
    public record Surface(Material material, Slot colour, Slot normal) {
        /** Returns true if faces of both materials have the same vertices and are in the same batch. */
        boolean isMeshedLike(Surface other) {
            return colour.array == other.colour.array
                    && normal.array == other.normal.array
                    && material.lambert() == other.material.lambert()
                    && material.textureMetres() == other.material.textureMetres();
        }
    }

    /**
     * Returns the materials of an edited level; known pictures are not read again, and unchanged parts are the same
     * objects.
     *
     * @throws nephele.engine.asset.AssetException naming the picture that cannot be used
     */
    SceneMaterials edited(List<Material> materials, AssetSource assets) {
        List<Material> before = surfaces.stream().skip(1).map(Surface::material).toList();
        if (!surfaces.isEmpty() && IdentityDiff.list(before, materials) == before) {
            return this;
        }
        Arrays colours = new Arrays(assets, colourArrays, PictureDecoder::decode);
        Arrays normals = new Arrays(assets, normalArrays, PictureDecoder::decodeNumbers);
        for (Surface surface : surfaces) {
            colours.know(surface.material().texture(), surface.colour());
            normals.know(surface.material().normalTexture(), surface.normal());
        }
        List<Surface> all = new ArrayList<>();
        Map<String, Integer> indexById = new HashMap<>();
        all.add(new Surface(Material.DEFAULT_GREY, Slot.NONE, Slot.NONE));
        for (Material material : materials) {
            indexById.put(material.id(), all.size());
            all.add(new Surface(material, colours.slot(material.texture()), normals.slot(material.normalTexture())));
        }
        return new SceneMaterials(List.copyOf(all), colours.finished(), normals.finished(), Map.copyOf(indexById));
    }

    /** Returns the ids of the materials that change the vertices or the batch of their faces. */
    Set<String> changedSince(SceneMaterials before) {
        Set<String> changed = new HashSet<>(indexById.keySet());
        changed.addAll(before.indexById.keySet());
        changed.removeIf(id -> indexOf(id) == before.indexOf(id)
                && surfaces.get(indexOf(id)).isMeshedLike(before.surfaces.get(indexOf(id))));
        return changed;
    }

    /**
     * Returns the index of a material, 0 for an unknown id.
     *
     * @param materialId {@code null} for the default grey
     */
    public int indexOf(String materialId) {
        return materialId == null ? 0 : indexById.getOrDefault(materialId, 0);
    }

    /** Collects pictures by size; each file is decoded once. */
    private static final class Arrays {
        private final AssetSource assets;
        private final BiFunction<String, byte[], Picture> decode;
        private final List<PictureArray> before;
        private final Map<String, Picture> known = new HashMap<>();
        private final Map<String, Slot> slots = new HashMap<>();
        private final Map<List<Integer>, Integer> arrayBySize = new LinkedHashMap<>();
        private final List<List<Picture>> arrays = new ArrayList<>();

        /** @param decode reads a picture of an id and its bytes */
        Arrays(AssetSource assets, List<PictureArray> before, BiFunction<String, byte[], Picture> decode) {
            this.assets = assets;
            this.decode = decode;
            this.before = before;
        }

        void know(String assetId, Slot slot) {
            if (assetId != null) {
                known.put(assetId, before.get(slot.array()).layers().get(slot.layer()));
            }
        }

        Slot slot(String assetId) {
            if (assetId == null) {
                return Slot.NONE;
            }
            return slots.computeIfAbsent(assetId, this::add);
        }

        private Slot add(String assetId) {
            Picture picture = known.computeIfAbsent(
                    assetId,
                    id -> PictureDecoder.inMemory(
                            id, () -> decode.apply(id, assets.bytes(id)).toRgba8()));
            int array = arrayBySize.computeIfAbsent(List.of(picture.width(), picture.height()), size -> {
                arrays.add(new ArrayList<>());
                return arrays.size() - 1;
            });
            arrays.get(array).add(picture);
            return new Slot(array, arrays.get(array).size() - 1);
        }

        List<PictureArray> finished() {
            return IdentityDiff.list(before, arrays.stream().map(this::finished).toList());
        }

        private PictureArray finished(List<Picture> layers) {
            return before.stream()
                    .filter(array -> IdentityDiff.list(array.layers(), layers) == array.layers())
                    .findFirst()
                    .orElseGet(() -> new PictureArray(
                            layers.get(0).width(), layers.get(0).height(), List.copyOf(layers)));
        }
    }
}
