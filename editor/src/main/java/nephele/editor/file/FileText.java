package nephele.editor.file;

import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import nephele.editor.text.Text;
import nephele.editor.text.Words;

/** A text about files in English, Brazilian and European Portuguese. */
public enum FileText implements Text {
    TODAY("today %s", "hoje, %s", "hoje, %s"),
    YESTERDAY("yesterday %s", "ontem, %s", "ontem, %s"),
    UNTITLED("Untitled, never saved", "Sem título, nunca salva", "Sem título, nunca guardado"),
    ONE_EDIT("1 edit", "1 edição", "1 edição"),
    EDITS("%s edits", "%s edições", "%s edições"),
    LAST_EDIT("last: %s", "última: %s", "última: %s"),
    RECOVERED("Recover Lost Work", "Recuperar trabalho perdido", "Recuperar trabalho perdido"),
    RECOVERED_STATUS(
            "%s is recovered and not saved yet; undo returns to what was saved",
            "%s foi recuperada e ainda não foi salva; desfazer volta ao que estava salvo",
            "%s foi recuperado e ainda não está guardado; anular volta ao que estava guardado"),
    RESTORED("Restore a Backup", "Restaurar uma cópia de segurança", "Repor uma cópia de segurança"),
    RESTORED_STATUS(
            "The version of %s is restored and not saved yet; undo takes it back",
            "A versão de %s foi restaurada e ainda não foi salva; desfazer volta atrás",
            "A versão de %s foi reposta e ainda não está guardada; anular volta atrás"),
    COPY_STATUS(
            "A copy of the version of %s is open; saving asks for its name",
            "Uma cópia da versão de %s está aberta; ao salvar, escolha o nome",
            "Uma cópia da versão de %s está aberta; ao guardar, escolhe o nome"),
    NO_BACKUP_NUMBER(
            "there is no backup %s: %s has %s",
            "não há a cópia de segurança %s: %s tem %s", "não há a cópia de segurança %s: %s tem %s"),
    BAD_BACKUP(
            "The backup can't be read: %s. Choose another one.",
            "A cópia de segurança não pode ser lida: %s. Escolha outra.",
            "A cópia de segurança não pode ser lida: %s. Escolhe outra."),
    UNPACKED("Unpacked to %s", "Descompactado em %s", "Descomprimido em %s"),
    EXPORTED("Exported to %s", "Exportado para %s", "Exportado para %s"),
    RELOAD("Reload from Disk", "Recarregar do disco", "Recarregar do disco"),
    RELOADED(
            "%s was changed by another program and is loaded again; undo returns to the version before",
            "%s foi alterado por outro programa e recarregado; desfazer volta à versão anterior",
            "%s foi alterado por outro programa e recarregado; anular volta à versão anterior"),
    ASSETS_RELOADED("Loaded again: %s", "Recarregado: %s", "Recarregado: %s"),
    NOT_RELOADED(
            "Another program has changed %s, but not to a level that can be read (%s). Your version is kept; saving"
                    + " asks before it replaces the file.",
            "Outro programa alterou %s, mas o resultado não é uma fase legível (%s). A sua versão foi mantida; ao"
                    + " salvar, o editor pergunta antes de substituir o arquivo.",
            "Outro programa alterou %s, mas o resultado não é um nível legível (%s). A tua versão foi mantida; ao"
                    + " guardar, o editor pergunta antes de substituir o ficheiro."),
    CHANGED_QUESTION(
            "Another program has changed %s, and you have changes that are not saved.\n"
                    + "The version that you do not choose is kept among the backups.",
            "Outro programa alterou %s, e você tem mudanças que não foram salvas.\n"
                    + "A versão que você não escolher fica nas cópias de segurança.",
            "Outro programa alterou %s, e tens alterações por guardar.\n"
                    + "A versão que não escolheres fica nas cópias de segurança."),
    LOSES(
            "The level has changes that are not saved. Go on without them?",
            "A fase tem mudanças que não foram salvas. Continuar sem elas?",
            "O nível tem alterações por guardar. Continuar sem elas?"),
    KEEP_MINE("Keep Mine", "Manter a minha", "Manter a minha"),
    LOAD_THEIRS("Load Theirs", "Carregar a outra", "Carregar a outra"),
    DELETED(
            "%s was deleted or moved by another program.\nYour level is still open here, and is kept among the backups."
                    + " Save writes the file again.",
            "%s foi apagado ou movido por outro programa.\nA sua fase continua aberta aqui e está nas cópias de"
                    + " segurança. Salvar grava o arquivo de novo.",
            "%s foi apagado ou movido por outro programa.\nO teu nível continua aberto aqui e está nas cópias de"
                    + " segurança. Guardar escreve o ficheiro de novo."),
    SAVE_AS("Save As…", "Salvar como…", "Guardar como…"),
    ADD_PICTURE("Add a Picture", "Adicionar uma imagem", "Adicionar uma imagem"),
    ADD_MODEL("Add a Model", "Adicionar um modelo", "Adicionar um modelo"),
    ADD_CLOUD("Add a Cloud", "Adicionar uma nuvem", "Adicionar uma nuvem"),
    ADDED("Added %s as %s", "%s foi adicionado como %s", "%s foi adicionado como %s"),
    IMPORTED("Imported as %s", "Importado como %s", "Importado como %s"),
    ADD_TERRAIN("Add a Terrain", "Adicionar um terreno", "Adicionar um terreno"),
    ADD_SCENE("Insert a Scene", "Inserir uma cena", "Inserir uma cena"),
    INSERTED("%s was inserted", "%s foi inserido", "%s foi inserido"),
    INSERT_OR_OPEN(
            "%s is a scene. Insert it into this level, or open it in place of this level?",
            "%s é uma cena. Inserir nesta fase ou abrir no lugar dela?",
            "%s é uma cena. Inserir neste nível ou abrir em vez dele?"),
    INSERT("Insert", "Inserir", "Inserir"),
    OPEN_INSTEAD("Open Instead", "Abrir no lugar", "Abrir em vez dele"),
    SAVE_FIRST(
            "Save the level first: %s is copied into the folder of its file",
            "Salve a fase antes: %s é copiado para a pasta do arquivo dela",
            "Guarda o nível primeiro: %s é copiado para a pasta do ficheiro dele"),
    UNUSABLE("%s can't be used (%s)", "%s não pode ser usado (%s)", "%s não pode ser usado (%s)"),
    NEIGHBOUR_TAKEN(
            "%s can't be copied beside the level: %s is another file already; rename one of them",
            "%s não pode ser copiado para junto da fase: %s já é outro arquivo; renomeie um deles",
            "%s não pode ser copiado para junto do nível: %s já é outro ficheiro; muda o nome de um deles"),
    UNKNOWN_KIND(
            "%s can't be used: drop pictures (png, jpg, bmp, tga), models (3d, obj, gltf, glb), clouds (vol), heights"
                    + " (r16), scenes (xml), levels (json) or packages (zip)",
            "%s não pode ser usado: solte imagens (png, jpg, bmp, tga), modelos (3d, obj, gltf, glb), nuvens (vol),"
                    + " alturas (r16), cenas (xml), fases (json) ou pacotes (zip)",
            "%s não pode ser usado: larga imagens (png, jpg, bmp, tga), modelos (3d, obj, gltf, glb), nuvens (vol),"
                    + " alturas (r16), cenas (xml), níveis (json) ou pacotes (zip)");

    private final Words words;

    FileText(String english, String brazilian, String european) {
        words = Words.of(english, brazilian, european);
    }

    @Override
    public Words words() {
        return words;
    }

    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm", Locale.ROOT);
    private static final DateTimeFormatter ENGLISH = DateTimeFormatter.ofPattern("d MMMM uuuu, HH:mm", Locale.ENGLISH);
    private static final DateTimeFormatter PORTUGUESE =
            DateTimeFormatter.ofPattern("d 'de' MMMM 'de' uuuu, HH:mm", Locale.forLanguageTag("pt"));

    /** Returns a time as people say it: {@code today 14:02}. */
    static Words time(Instant time, Instant now, ZoneId zone) {
        ZonedDateTime local = time.atZone(zone);
        LocalDate today = now.atZone(zone).toLocalDate();
        if (local.toLocalDate().equals(today)) {
            return TODAY.with(CLOCK.format(local));
        }
        if (local.toLocalDate().equals(today.minusDays(1))) {
            return YESTERDAY.with(CLOCK.format(local));
        }
        String portuguese = PORTUGUESE.format(local);
        return Words.of(ENGLISH.format(local), portuguese, portuguese);
    }
}
