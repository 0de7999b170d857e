package nephele.editor.text;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

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

    private static final Map<String, Words> KINDS = Map.ofEntries(
            word("atmosphere", "Atmosphere", "Atmosfera", "Atmosfera"),
            word("billboards", "Billboards", "Placas", "Placas"),
            word("box", "Box", "Caixa", "Caixa"),
            word("camera", "Camera", "Câmera", "Câmara"),
            word("capsule", "Capsule", "Cápsula", "Cápsula"),
            word("cloud", "Cloud", "Nuvem", "Nuvem"),
            word("constant", "Even", "Uniforme", "Uniforme"),
            word("emitter", "Particles", "Partículas", "Partículas"),
            word("exit", "Exit", "Saída", "Saída"),
            word("fog", "Fog", "Neblina", "Nevoeiro"),
            word("hint", "Hint", "Dica", "Pista"),
            word("lightning", "Lightning", "Relâmpagos", "Relâmpagos"),
            word("gradient", "Gradient", "Gradiente", "Gradiente"),
            word("material", "Material", "Material", "Material"),
            word("modelplacement", "Model", "Modelo", "Modelo"),
            word("observer", "Observer's sphere", "Esfera do observador", "Esfera do observador"),
            word("par", "Par of the level", "Meta da fase", "Meta do nível"),
            word("place", "Place", "Lugar", "Lugar"),
            word("planes", "Solid of planes", "Sólido de planos", "Sólido de planos"),
            word("playerstart", "Player start", "Início do jogador", "Início do jogador"),
            word("point", "Point light", "Luz pontual", "Luz pontual"),
            word("portalgun", "Portal gun", "Arma de portais", "Arma de portais"),
            word("portalspec", "Portal", "Portal", "Portal"),
            word("prism", "Prism", "Prisma", "Prisma"),
            word("skybox", "Sky box", "Caixa de céu", "Caixa de céu"),
            word("sphere", "Sphere", "Esfera", "Esfera"),
            word("spot", "Spot light", "Refletor", "Projetor"),
            word("sun", "Sun", "Sol", "Sol"),
            word("terrain", "Terrain", "Terreno", "Terreno"),
            word("wedge", "Wedge", "Cunha", "Cunha"));

    /** The headings by sections, or by kinds of sections, in the order of the palette. */
    private static final Map<String, Group> GROUPS = new LinkedHashMap<>();
    /** Names that a section gives to its kinds. */
    private static final Map<String, Words> IN_SECTION = new HashMap<>();

    private static final Map<String, Words> SECTIONS = new LinkedHashMap<>();

    static {
        palette("player", Group.PLAY, Words.of("Start", "Início", "Início"));
        palette("exits", Group.PLAY);
        palette("bodies.box", Group.PLAY, Words.of("Cube", "Cubo", "Cubo"));
        palette("bodies.sphere", Group.PLAY, Words.of("Ball", "Bola", "Bola"));
        palette("bodies", Group.PLAY);
        palette("portals", Group.PLAY);
        palette("portalGun", Group.PLAY);
        palette("observer", Group.PLAY);
        palette("par", Group.PLAY);
        palette("landmark", Group.PLAY, Words.of("Landmark", "Marco", "Marco"));
        palette("hints", Group.PLAY);
        palette("lights", Group.LIGHT);
        palette("environment.sun", Group.LIGHT);
        palette("emitters", Group.SCENE);
        palette("billboards", Group.SCENE);
        palette("environment.clouds", Group.SKY);
        palette("environment.sky", Group.SKY);
        palette("environment.fog", Group.SKY);
        palette("environment.lightning", Group.SKY);
        palette("terrains", Group.SCENE);
        palette("models", Group.SCENE);
        palette("cameras", Group.SCENE);
        palette("materials", Group.SCENE);
        palette("solids", Group.SOLIDS);
        SECTIONS.put("solids", Words.of("Brushes", "Blocos", "Blocos"));
        SECTIONS.put("player", Words.of("Start", "Início", "Início"));
    }

    private EntityWords() {}

    private static void palette(String key, Group group) {
        GROUPS.put(key, group);
    }

    private static void palette(String key, Group group, Words words) {
        GROUPS.put(key, group);
        IN_SECTION.put(key, words);
    }

    private static <T> Optional<T> find(Map<String, T> all, String section, String kind) {
        return Optional.ofNullable(all.getOrDefault(section + "." + kind, all.get(section)));
    }

    /** Returns the name of a kind of entity of a section, such as "Cube" for {@code bodies}, {@code box}. */
    public static Words ofKind(String section, String kind) {
        return find(IN_SECTION, section, kind).orElseGet(() -> ofKind(kind));
    }

    /** Returns the heading under which the palette offers a kind. */
    public static Group group(String section, String kind) {
        return find(GROUPS, section, kind).orElse(Group.OTHER);
    }

    /** Returns the place of a kind in the order of the palette. */
    public static int rank(String section, String kind) {
        List<String> order = List.copyOf(GROUPS.keySet());
        String key = section + "." + kind;
        int rank = order.indexOf(GROUPS.containsKey(key) ? key : section);
        return rank < 0 ? order.size() : rank;
    }

    /** Returns the name of a section, such as "Lights" for {@code lights}. */
    public static Words ofSection(String path) {
        String last = path.substring(path.lastIndexOf('.') + 1);
        return Optional.ofNullable(SECTIONS.get(path))
                .or(() -> FieldWords.known(last))
                .orElseGet(() -> Words.same(FieldWords.sentence(last)));
    }

    private static Map.Entry<String, Words> word(String name, String english, String brazilian, String european) {
        return Map.entry(name, Words.of(english, brazilian, european));
    }

    /** Returns the words of a kind of records, whatever its section. */
    public static Words ofKind(String kind) {
        return knownKind(kind).orElseGet(() -> Words.same(FieldWords.sentence(kind)));
    }

    /** Returns the words of a kind; empty for an unknown one. */
    public static Optional<Words> knownKind(String kind) {
        return Optional.ofNullable(KINDS.get(kind));
    }
}
