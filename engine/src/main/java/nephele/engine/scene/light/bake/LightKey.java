package nephele.engine.scene.light.bake;

import java.io.BufferedOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.lang.reflect.RecordComponent;
import java.nio.charset.StandardCharsets;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import nephele.engine.asset.AssetSource;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.TextKind;
import nephele.engine.level.TexturePlacement;
import nephele.engine.level.Written;
import nephele.engine.level.placed.PlacedLevel;

/**
 * The part of a level that its baked light depends on: solids, models, terrains and billboards with the materials that
 * they use, lights, sun, sky, clouds and fog. Names, cameras, the player, portals, bodies and exposure are no part of it.
 *
 * @param fileName of the light, a hash of the records alone, which takes no time; {@link #content} hashes the files
 * @param assetIds the files that the records name, sorted
 */
public record LightKey(String fileName, List<String> assetIds) {
    /** Part of every name: raise it whenever the same level would bake to other light. */
    private static final int VERSION = 1;

    /** The glob of the files' names. */
    public static final String NAMES = "light-*.bin";

    private static final int NAME_BYTES = 10;

    /** Components on which no light depends. */
    private static final Set<String> UNLIT =
            Set.of("id", "portalable", "exposureStops", "toneCurve", "lightning", "technique", "tolerance");

    /** Returns the key of a level. */
    public static LightKey of(PlacedLevel placed) {
        Level level = placed.level();
        MessageDigest digest = SkyVisibilityFile.sha256();
        try (var words = new DataOutputStream(
                new BufferedOutputStream(new DigestOutputStream(OutputStream.nullOutputStream(), digest)))) {
            words.writeInt(VERSION);
            var walk = new Walk(level, words);
            walk.value(level.environment(), null);
            for (List<?> section : List.of(level.lights(), level.models(), level.terrains(), level.billboards())) {
                walk.value(section, null);
            }
            for (Brush brush : placed.statics().solids()) {
                walk.solid(brush);
            }
            words.flush();
            String hash = HexFormat.of().formatHex(digest.digest(), 0, NAME_BYTES);
            return new LightKey(NAMES.replace("*", hash), List.copyOf(walk.assetIds));
        } catch (IOException never) {
            throw new UncheckedIOException(never);
        }
    }

    /**
     * Returns the SHA-256 of the shapes and of the bytes of the files.
     *
     * @param geometry {@link SkyVisibilityFile#nameFor} of the shapes
     * @throws nephele.engine.asset.AssetException if a file cannot be read
     */
    public byte[] content(AssetSource assets, String geometry) {
        MessageDigest digest = SkyVisibilityFile.sha256();
        digest.update(geometry.getBytes(StandardCharsets.US_ASCII));
        for (String id : assetIds) {
            // A mesh that is generated from its name has no file.
            digest.update(assets.exists(id) ? SkyVisibilityFile.sha256().digest(assets.bytes(id)) : new byte[1]);
        }
        return digest.digest();
    }

    /** Writes records to a digest, whatever their ids are. */
    private static final class Walk {
        private final Map<String, Material> materials = new HashMap<>();
        private final Map<String, Integer> known = new HashMap<>();
        private final Map<String, List<String>> idsOf;
        private final Map<Class<?>, List<RecordComponent>> components = new HashMap<>();
        private final DataOutputStream words;
        private final Set<String> assetIds = new TreeSet<>();

        Walk(Level level, DataOutputStream words) {
            level.materials().forEach(material -> materials.putIfAbsent(material.id(), material));
            idsOf = Map.of(
                    "models", level.models().stream().map(model -> model.id()).toList(),
                    "terrains",
                            level.terrains().stream()
                                    .map(terrain -> terrain.id())
                                    .toList());
            this.words = words;
        }

        /** Writes a solid; not by reflection, because there are thousands while a level loads. */
        void solid(Brush brush) throws IOException {
            words.writeInt(brush.faces().size());
            for (Brush.BrushFace face : brush.faces()) {
                number(face.plane().nx());
                number(face.plane().ny());
                number(face.plane().nz());
                number(face.plane().distance());
                TexturePlacement picture = face.texture() == null ? TexturePlacement.NONE : face.texture();
                number(picture.shiftUMetres());
                number(picture.shiftVMetres());
                number(picture.rotationDegrees());
                number(picture.scaleU());
                number(picture.scaleV());
                words.writeUTF(String.valueOf(face.textureMapping()));
                material(face.material());
            }
        }

        /** @param id {@code null} for grey */
        private void material(String id) throws IOException {
            Integer before = known.putIfAbsent(id, known.size());
            words.writeInt(before == null ? -1 : before);
            if (before == null && materials.containsKey(id)) {
                members(materials.get(id));
            }
        }

        /**
         * Writes a number as a float, which drops the last bits, in which the sun of an hour differs between machines; adding
         * zero drops the sign of −0.
         */
        private void number(double number) throws IOException {
            words.writeFloat((float) (number + 0.0));
        }

        /** @param written how a file has the value; {@code null} for one without a declaration */
        void value(Object value, Written written) throws IOException {
            if (value instanceof List<?> list) {
                words.writeInt(list.size());
                for (Object entry : list) {
                    value(entry, written);
                }
            } else if (value instanceof Map<?, ?> table) {
                words.writeInt(table.size());
                // Some maps have another order in every process.
                List<Map.Entry<?, ?>> sorted = new ArrayList<>(table.entrySet());
                sorted.sort(Comparator.comparing(entry -> entry.getKey().toString()));
                for (Map.Entry<?, ?> entry : sorted) {
                    words.writeUTF(entry.getKey().toString());
                    value(entry.getValue(), written);
                }
            } else if (value instanceof Record record) {
                members(record);
            } else if (value instanceof String text) {
                text(text, written);
            } else if (value instanceof Double number) {
                number(number);
            } else {
                words.writeUTF(String.valueOf(value));
            }
        }

        private void members(Record record) throws IOException {
            words.writeUTF(record.getClass().getSimpleName());
            for (RecordComponent component : componentsOf(record.getClass())) {
                try {
                    value(component.getAccessor().invoke(record), component.getAnnotation(Written.class));
                } catch (ReflectiveOperationException e) {
                    throw new IllegalStateException(e);
                }
            }
        }

        private List<RecordComponent> componentsOf(Class<?> type) {
            return components.computeIfAbsent(type, any -> {
                List<RecordComponent> all = new ArrayList<>(List.of(type.getRecordComponents()));
                all.removeIf(component -> UNLIT.contains(component.getName()));
                all.forEach(component -> component.getAccessor().setAccessible(true));
                return all;
            });
        }

        private void text(String text, Written written) throws IOException {
            String section = written == null ? "" : written.refersTo();
            if (section.equals("materials")) {
                material(text);
            } else if (!section.isEmpty()) {
                words.writeInt(idsOf.getOrDefault(section, List.of()).indexOf(text));
            } else {
                words.writeUTF(text);
                if (written != null && written.text() == TextKind.ASSET) {
                    assetIds.add(text);
                }
            }
        }
    }
}
