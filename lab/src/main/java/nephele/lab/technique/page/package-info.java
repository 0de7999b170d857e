/** The opening table of the report on techniques of clouds, and a page for teachers about each technique. */
package nephele.lab.technique.page;
