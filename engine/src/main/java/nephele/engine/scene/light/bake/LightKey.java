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
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.TextKind;
import nephele.engine.level.Written;
import nephele.engine.level.appearance.Daylight;

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
            Set.of("portalable", "exposureStops", "toneCurve", "lightning", "technique", "tolerance");

    /** Returns the key of a level. */
    public static LightKey of(Level authored) {
        Level level = Daylight.lit(authored);
        MessageDigest digest = SkyVisibilityFile.sha256();
        try (var words = new DataOutputStream(
                new BufferedOutputStream(new DigestOutputStream(OutputStream.nullOutputStream(), digest)))) {
            words.writeInt(VERSION);
            var walk = new Walk(level, words);
            walk.value(level.environment(), null);
            for (List<?> section :
                    List.of(level.solids(), level.lights(), level.models(), level.terrains(), level.billboards())) {
                walk.value(section, null);
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
                // A float drops the last bits, in which the sun of an hour differs between machines, and adding zero
                // the
                // sign of −0.
                words.writeFloat((float) (number + 0.0));
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
            boolean isId = written != null && written.text() == TextKind.ID;
            if (!isId) {
                words.writeUTF(text);
                if (written != null && written.text() == TextKind.ASSET) {
                    assetIds.add(text);
                }
            } else if (written.refersTo().equals("materials")) {
                Integer before = known.putIfAbsent(text, known.size());
                if (before != null) {
                    words.writeInt(before);
                } else if (materials.containsKey(text)) {
                    members(materials.get(text));
                }
            } else if (!written.refersTo().isEmpty()) {
                words.writeInt(idsOf.getOrDefault(written.refersTo(), List.of()).indexOf(text));
            }
        }
    }
}
