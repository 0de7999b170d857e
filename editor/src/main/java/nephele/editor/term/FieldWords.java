package nephele.editor.term;

import static java.util.Map.entry;

import java.util.Map;
import java.util.Optional;
import nephele.editor.record.RecordField;
import nephele.editor.text.Words;

/** The names of record components in words. A component that has none here is named by its English identifier. */
public final class FieldWords {
    private static final Map<String, Words> ALL = Map.ofEntries(
            word("aim", "View at the start", "Vista inicial", "Vista inicial"),
            word("albedo", "Albedo", "Albedo", "Albedo"),
            word("ambient", "Ambient light", "Luz ambiente", "Luz ambiente"),
            word("angleDegrees", "Angle", "Ângulo", "Ângulo"),
            word("anvil", "Anvil", "Bigorna", "Bigorna"),
            word("axis", "Axis", "Eixo", "Eixo"),
            word("backLobe", "Back lobe", "Lobo traseiro", "Lobo traseiro"),
            word("baseAltitudeMetres", "Base altitude", "Altitude da base", "Altitude da base"),
            word("baseColour", "Base colour", "Cor base", "Cor base"),
            word("bodies", "Bodies", "Corpos", "Corpos"),
            word("boxes", "Boxes", "Caixas", "Caixas"),
            word("by", "By", "Quanto", "Quanto"),
            word("cameras", "Cameras", "Câmeras", "Câmaras"),
            word("castsShadow", "Casts shadow", "Projeta sombra", "Projeta sombra"),
            word("centre", "Centre", "Centro", "Centro"),
            word("clouds", "Clouds", "Nuvens", "Nuvens"),
            word("count", "Count", "Quantidade", "Quantidade"),
            word("coverage", "Coverage", "Cobertura", "Cobertura"),
            word("coverageMap", "Coverage map", "Mapa de cobertura", "Mapa de cobertura"),
            word("dayLengthSeconds", "Length of a day", "Duração do dia", "Duração do dia"),
            word("dayOfYear", "Day of the year", "Dia do ano", "Dia do ano"),
            word("density", "Density", "Densidade", "Densidade"),
            word("description", "Description", "Descrição", "Descrição"),
            word("direction", "Direction", "Direção", "Direção"),
            word("directionTowardsSun", "Direction towards the sun", "Direção até o sol", "Direção até ao sol"),
            word("distanceMetres", "Distance", "Distância", "Distância"),
            word("editor", "Editor", "Editor", "Editor"),
            word("emitters", "Particles", "Partículas", "Partículas"),
            word("emission", "Emission", "Emissão", "Emissão"),
            word("environment", "Environment", "Ambiente", "Ambiente"),
            word("erosion", "Erosion", "Erosão", "Erosão"),
            word("evolutionSeconds", "Evolution", "Evolução", "Evolução"),
            word("exits", "Exits", "Saídas", "Saídas"),
            word("exposureStops", "Exposure", "Exposição", "Exposição"),
            word("extent", "Extent", "Extensão", "Extensão"),
            word("extinctionPerMetre", "Extinction", "Extinção", "Extinção"),
            word("faces", "Faces", "Faces", "Faces"),
            word("farMetres", "Far distance", "Distância máxima", "Distância máxima"),
            word("featureMetres", "Feature size", "Tamanho dos detalhes", "Tamanho dos detalhes"),
            word("feet", "Feet", "Pés", "Pés"),
            word("file", "File", "Arquivo", "Ficheiro"),
            word("files", "Files", "Arquivos", "Ficheiros"),
            word("fill", "Fill", "Preenchimento", "Preenchimento"),
            word("fog", "Fog", "Neblina", "Nevoeiro"),
            word("friction", "Friction", "Atrito", "Atrito"),
            word("ground", "Ground", "Solo", "Solo"),
            word("groundAlbedo", "Albedo of the ground", "Albedo do solo", "Albedo do solo"),
            word("groups", "Groups", "Grupos", "Grupos"),
            word("heightMetres", "Height", "Altura", "Altura"),
            word("hidden", "Hidden", "Ocultos", "Ocultos"),
            word("horizon", "Horizon", "Horizonte", "Horizonte"),
            word(
                    "horizontalFovDegrees",
                    "Horizontal field of view",
                    "Campo de visão horizontal",
                    "Campo de visão horizontal"),
            word("id", "Id", "Id", "Id"),
            word("ignoredProblems", "Ignored problems", "Problemas ignorados", "Problemas ignorados"),
            word("innerConeDegrees", "Inner cone", "Cone interno", "Cone interior"),
            word("irradiance", "Irradiance", "Irradiância", "Irradiância"),
            word("kind", "Kind", "Tipo", "Tipo"),
            word("latitudeDegrees", "Latitude", "Latitude", "Latitude"),
            word("layout", "Layout", "Disposição", "Disposição"),
            word("lights", "Lights", "Luzes", "Luzes"),
            word("linkedTo", "Linked to", "Ligado a", "Ligado a"),
            word("locked", "Locked", "Bloqueados", "Bloqueados"),
            word("massKilograms", "Mass", "Massa", "Massa"),
            word("material", "Material", "Material", "Material"),
            word("materials", "Materials", "Materiais", "Materiais"),
            word("members", "Members", "Membros", "Membros"),
            word("metallic", "Metallic", "Metálico", "Metálico"),
            word("maxErrorPercent", "Allowed error of light", "Erro permitido da luz", "Erro permitido da luz"),
            word("maxErrorPixels", "Allowed displacement", "Deslocamento permitido", "Deslocamento permitido"),
            word("mieG", "Haze forward (g)", "Névoa à frente (g)", "Névoa à frente (g)"),
            word("mieScale", "Haze", "Névoa", "Névoa"),
            word("mirror", "Mirror", "Espelho", "Espelho"),
            word("models", "Models", "Modelos", "Modelos"),
            word("motion", "Motion", "Movimento", "Movimento"),
            word("name", "Name", "Nome", "Nome"),
            word("nearMetres", "Near distance", "Distância mínima", "Distância mínima"),
            word("normal", "Normal", "Normal", "Normal"),
            word("normalTexture", "Normal texture", "Textura de normais", "Textura de normais"),
            word("outerConeDegrees", "Outer cone", "Cone externo", "Cone exterior"),
            word("ozoneScale", "Ozone", "Ozônio", "Ozono"),
            word("parent", "Parent", "Objeto pai", "Objeto pai"),
            word("path", "Path", "Percurso", "Percurso"),
            word("phaseBackG", "Back lobe g", "Lobo traseiro g", "Lobo traseiro g"),
            word("phaseBackShare", "Back lobe share", "Parte do lobo traseiro", "Parte do lobo traseiro"),
            word("phaseG", "Phase g", "Fase g", "Fase g"),
            word("pitchDegrees", "Pitch", "Arfagem", "Inclinação"),
            word("planes", "Planes", "Planos", "Planos"),
            word("player", "Player", "Jogador", "Jogador"),
            word("portalable", "Takes portals", "Aceita portais", "Aceita portais"),
            word("portalGun", "Portal gun", "Arma de portais", "Arma de portais"),
            word("portals", "Portals", "Portais", "Portais"),
            word("position", "Position", "Posição", "Posição"),
            word("profile", "Profile", "Perfil", "Perfil"),
            word("puffs", "Puffs", "Tufos", "Tufos"),
            word("radiance", "Radiance", "Radiância", "Radiância"),
            word("radiantIntensity", "Radiant intensity", "Intensidade radiante", "Intensidade radiante"),
            word("radiusMetres", "Radius", "Raio", "Raio"),
            word("rangeMetres", "Range", "Alcance", "Alcance"),
            word("ratePerSecond", "Rate", "Taxa", "Taxa"),
            word("repeatSeconds", "Repeated after", "Repete após", "Repete após"),
            word("restitution", "Restitution", "Restituição", "Restituição"),
            word("rising", "High side", "Lado alto", "Lado alto"),
            word("rotationDegrees", "Rotation", "Rotação", "Rotação"),
            word("roughness", "Roughness", "Rugosidade", "Rugosidade"),
            word("scaleU", "Scale u", "Escala u", "Escala u"),
            word("scaleV", "Scale v", "Escala v", "Escala v"),
            word("seed", "Seed", "Semente", "Semente"),
            word("shafts", "Shadows in the air", "Sombras no ar", "Sombras no ar"),
            word("shape", "Shape", "Forma", "Forma"),
            word("shiftUMetres", "Shift u", "Deslocamento u", "Deslocamento u"),
            word("shiftVMetres", "Shift v", "Deslocamento v", "Deslocamento v"),
            word("sides", "Sides", "Lados", "Lados"),
            word("size", "Size", "Tamanho", "Tamanho"),
            word("sky", "Sky", "Céu", "Céu"),
            word("solids", "Solids", "Sólidos", "Sólidos"),
            word("sun", "Sun", "Sol", "Sol"),
            word("startSeconds", "Start", "Início", "Início"),
            word("sunRadiusDegrees", "Radius of the sun", "Raio do Sol", "Raio do Sol"),
            word("target", "Target", "Alvo", "Alvo"),
            word("technique", "Technique", "Técnica", "Técnica"),
            word("texture", "Texture", "Textura", "Textura"),
            word("textureMapping", "Texture mapping", "Projeção da textura", "Projeção da textura"),
            word("textureMetres", "Texture size", "Tamanho da textura", "Tamanho da textura"),
            word("thicknessMetres", "Thickness", "Espessura", "Espessura"),
            word("timeOfDayHours", "Time of day", "Hora do dia", "Hora do dia"),
            word("timeSeconds", "Time", "Instante", "Instante"),
            word("toneCurve", "Tone curve", "Curva de tons", "Curva de tons"),
            word("transform", "Transform", "Transformação", "Transformação"),
            word("up", "Up", "Para cima", "Para cima"),
            word("verticalFovDegrees", "Vertical field of view", "Campo de visão vertical", "Campo de visão vertical"),
            word("weather", "Weather", "Tempo", "Tempo"),
            word("weatherKeyframes", "Weather over time", "Mudanças do tempo", "Mudanças do tempo"),
            word("weatherSeed", "Seed of the weather", "Semente do tempo", "Semente do tempo"),
            word("whiteRadiance", "Radiance of white", "Radiância do branco", "Radiância do branco"),
            word("widthMetres", "Width", "Largura", "Largura"),
            word("windMetresPerSecond", "Wind", "Vento", "Vento"),
            word("yawDegrees", "Yaw", "Guinada", "Rumo"),
            word("zenith", "Zenith", "Zênite", "Zénite"));

    private FieldWords() {}

    private static Map.Entry<String, Words> word(String name, String english, String brazilian, String european) {
        return entry(name, Words.of(english, brazilian, european));
    }

    /** Returns the words of a component, without its unit; the identifier in words if there are none. */
    public static Words of(RecordField field) {
        return known(field.name()).orElseGet(() -> Words.same(sentence(field.title())));
    }

    /** Returns the words of a component's name; empty for an unknown one. */
    public static Optional<Words> known(String name) {
        return Optional.ofNullable(ALL.get(name));
    }

    static String sentence(String words) {
        return words.isEmpty() ? words : Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }
}
