/** Commands of one or two classes, and the options and outputs that commands share; larger commands have packages. Nothing else knows picocli. */
package sunbeam.app.cli;
