/**
 * Small JSON files that the program keeps for its user. {@link nephele.host.userfile.UserFile} never fails to read:
 * damaged files give the backup or nothing, and everything that the program does not understand is kept.
 */
package nephele.host.userfile;
