package nephele.editor.panel.model;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import nephele.editor.text.Words;

/** The names that a designer reads for sections and kinds of entities; one without a name here is called as in files. */
public final class EntityWords {
    /** A heading of the palette. */
    public enum Group {
        PLAY("Game", "Jogo", "Jogo"),
        LIGHT("Light", "Luz", "Luz"),
        SKY("Sky and air", "Céu e ar", "Céu e ar"),
        SCENE("Scene", "Cena", "Cena"),
        SOLIDS("Exact solids", "Sólidos exatos", "Sólidos exatos"),
        OTHER("Other", "Outros", "Outros");

        private final Words words;

        Group(String english, String brazilian, String european) {
            words = Words.of(english, brazilian, european);
        }

        public Words words() {
            return words;
        }
    }

    private record Named(Group group, Words words) {}

    private static final Map<String, Named> KINDS = new LinkedHashMap<>();
    private static final Map<String, Words> SECTIONS = new LinkedHashMap<>();

    static {
        kind("environment.sun", Group.LIGHT, Words.of("Sun", "Sol", "Sol"));
        kind("lights.point", Group.LIGHT, Words.of("Point lamp", "Lâmpada pontual", "Lâmpada pontual"));
        kind("lights.spot", Group.LIGHT, Words.of("Spot lamp", "Refletor", "Projetor"));
        kind("environment.sky.gradient", Group.SKY, Words.of("Gradient sky", "Céu em degradê", "Céu em gradiente"));
        kind("environment.sky.constant", Group.SKY, Words.of("Even sky", "Céu uniforme", "Céu uniforme"));
        kind("environment.sky.skybox", Group.SKY, Words.of("Skybox", "Skybox", "Skybox"));
        kind("environment.sky.atmosphere", Group.SKY, Words.of("Atmosphere", "Atmosfera", "Atmosfera"));
        kind("environment.fog", Group.SKY, Words.of("Fog", "Neblina", "Nevoeiro"));
        kind("environment.clouds", Group.SKY, Words.of("Cloud volume", "Volume de nuvem", "Volume de nuvem"));
        kind("player", Group.PLAY, Words.of("Start", "Início", "Início"));
        kind("exits", Group.PLAY, Words.of("Exit", "Saída", "Saída"));
        kind("portals", Group.PLAY, Words.of("Portal", "Portal", "Portal"));
        kind("portalGun", Group.PLAY, Words.of("Portal gun", "Arma de portais", "Arma de portais"));
        kind("bodies.box", Group.PLAY, Words.of("Cube", "Cubo", "Cubo"));
        kind("bodies.sphere", Group.PLAY, Words.of("Ball", "Bola", "Bola"));
        kind("bodies.capsule", Group.PLAY, Words.of("Capsule", "Cápsula", "Cápsula"));
        kind("models", Group.SCENE, Words.of("Model", "Modelo", "Modelo"));
        kind("cameras", Group.SCENE, Words.of("Camera", "Câmera", "Câmara"));
        kind("materials", Group.SCENE, Words.of("New material", "Novo material", "Novo material"));
        kind("solids.box", Group.SOLIDS, Words.of("Box 1 m", "Caixa de 1 m", "Caixa de 1 m"));
        kind("solids.wedge", Group.SOLIDS, Words.of("Wedge 1 m", "Cunha de 1 m", "Cunha de 1 m"));
        kind("solids.prism", Group.SOLIDS, Words.of("Prism", "Prisma", "Prisma"));
        kind("solids.planes", Group.SOLIDS, Words.of("Cube of planes", "Cubo de planos", "Cubo de planos"));
        SECTIONS.put("environment", Words.of("Environment", "Ambiente", "Ambiente"));
        SECTIONS.put("environment.sun", Words.of("Sun", "Sol", "Sol"));
        SECTIONS.put("environment.sky", Words.of("Sky", "Céu", "Céu"));
        SECTIONS.put("environment.fog", Words.of("Fog", "Neblina", "Nevoeiro"));
        SECTIONS.put("environment.clouds", Words.of("Clouds", "Nuvens", "Nuvens"));
        SECTIONS.put("player", Words.of("Start", "Início", "Início"));
        SECTIONS.put("portalGun", Words.of("Portal gun", "Arma de portais", "Arma de portais"));
        SECTIONS.put("cameras", Words.of("Cameras", "Câmeras", "Câmaras"));
        SECTIONS.put("materials", Words.of("Materials", "Materiais", "Materiais"));
        SECTIONS.put("solids", Words.of("Brushes", "Blocos", "Blocos"));
        SECTIONS.put("lights", Words.of("Lamps", "Lâmpadas", "Lâmpadas"));
        SECTIONS.put("portals", Words.of("Portals", "Portais", "Portais"));
        SECTIONS.put("models", Words.of("Models", "Modelos", "Modelos"));
        SECTIONS.put("bodies", Words.of("Bodies", "Corpos", "Corpos"));
        SECTIONS.put("exits", Words.of("Exits", "Saídas", "Saídas"));
    }

    private EntityWords() {}

    private static void kind(String key, Group group, Words words) {
        KINDS.put(key, new Named(group, words));
    }

    private static Named find(String section, String kind) {
        Named named = KINDS.get(section + "." + kind);
        return named == null ? KINDS.get(section) : named;
    }

    /** Returns the name of a kind of entity of a section, such as "Point lamp" for {@code lights}, {@code point}. */
    public static Words ofKind(String section, String kind) {
        Named named = find(section, kind);
        return named == null ? Words.same(humanised(kind)) : named.words();
    }

    /** Returns the heading under which the palette offers a kind. */
    public static Group group(String section, String kind) {
        Named named = find(section, kind);
        return named == null ? Group.OTHER : named.group();
    }

    /** Returns the name of a section, such as "Lamps" for {@code lights}. */
    public static Words ofSection(String path) {
        return SECTIONS.getOrDefault(path, Words.same(humanised(path.substring(path.lastIndexOf('.') + 1))));
    }

    private static String humanised(String name) {
        String spaced = name.replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
        return spaced.isEmpty() ? spaced : Character.toUpperCase(spaced.charAt(0)) + spaced.substring(1);
    }
}
